"""Physics engines on the hoop's motions, scored against the truth: the benchmark hophoop-bench/1."""

from hophoop.engines.comparing import Comparison, Row, compare, score_file
from hophoop.engines.measures import Measures, measure
from hophoop.engines.phases import Phase, phases
from hophoop.engines.recording import Recording, load_csv, read_csv, to_csv
from hophoop.engines.registry import Engine, command_engine, engine, engines
from hophoop.engines.report import write
from hophoop.engines.scenarios import BENCHMARK, BenchScenario, bench_scenarios
from hophoop.engines.scores import Scores, score
from hophoop.engines.task import BodyState, States, Task, task_of
from hophoop.engines.truth import Truth, schema, truths

__all__ = [
    "BENCHMARK", "BenchScenario", "BodyState", "Comparison", "Engine", "Measures", "Phase", "Recording", "Row", "Scores",
    "States", "Task", "Truth", "bench_scenarios", "command_engine", "compare", "engine", "engines", "load_csv", "measure",
    "phases", "read_csv", "schema", "score", "score_file", "task_of", "to_csv", "truths", "write",
]  # fmt: skip
