"""Answers to programs: requests, limits and results, independent of HTTP."""
