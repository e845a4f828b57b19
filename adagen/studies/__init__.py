"""Studies of what is emitted, apart from the compiler: times, error beside time, stability."""
