"""Pictures of programs, schedules and robots as SVG; the same bytes for the same arguments."""
