"""Schedules: which process joins which partial chains, and the predicted cost of that."""

from adagen.schedule.fat_tree import Fabric, read_fabric, shipped_fabric
from adagen.schedule.hosts import Host, read_hosts
from adagen.schedule.profile import CostProfile, load_profile, parse_profile, step_costs, with_steps
from adagen.schedule.sweeps import makespan_of
from adagen.schedule.text import (
    gathered_line,
    schedule_line,
    schedule_to_dict,
    schedule_to_json,
    schedule_tree,
)
from adagen.schedule.topology import Topology
from adagen.schedule.tree import Node, Schedule, levels, postorder, preorder
from adagen.schedule.validity import InvalidSchedule, validate

__all__ = [
    "CostProfile",
    "Fabric",
    "Host",
    "InvalidSchedule",
    "Node",
    "Schedule",
    "Topology",
    "gathered_line",
    "levels",
    "load_profile",
    "makespan_of",
    "parse_profile",
    "postorder",
    "preorder",
    "read_fabric",
    "read_hosts",
    "schedule_line",
    "schedule_to_dict",
    "schedule_to_json",
    "schedule_tree",
    "shipped_fabric",
    "step_costs",
    "validate",
    "with_steps",
]
