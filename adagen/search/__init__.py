"""Schedules searched at the price that is played."""
