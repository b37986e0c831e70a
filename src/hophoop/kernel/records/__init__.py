"""What passes through the kernels and out of them: state, events, segments, scratch arrays."""
