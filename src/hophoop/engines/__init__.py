"""Physics engines on the hoop's motions, scored against the truth: the benchmark hophoop-bench/1."""
