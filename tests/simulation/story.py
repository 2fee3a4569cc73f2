"""The trace of a failure: the shortest scenario, within a few hundred runs, that breaks the same rule.

A plan is shortened by leaving out programs, links, tasks, steps, faults and mishaps, large pieces first. The remaining
parts keep their positions, so the seed and the shortened plan reproduce the failure.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar

from simulation.world import Scenario

if TYPE_CHECKING:
    from collections.abc import Iterator

    from simulation.plan import Life, Plan, ProgramPlan, Step
    from simulation.world import Outcome

MOST_RUNS = 400
MOST_EVENTS = 60
T = TypeVar("T")


def shrink(outcome: Outcome, most_runs: int = MOST_RUNS) -> Outcome:
    """Return the run of a shorter plan that breaks the same rule, or the run itself if none is found."""
    assert outcome.error is not None
    kind, best, runs = outcome.error.kind, outcome, 0
    shorter = True
    while shorter:
        shorter = False
        for plan in _cuts(best.plan):
            if runs == most_runs:
                return best
            runs += 1
            attempt = Scenario(plan).run()
            if attempt.error is not None and attempt.error.kind == kind:
                best, shorter = attempt, True
                break
    return best


def tell(outcome: Outcome, shortest: Outcome) -> str:
    """Return the trace as text: the seed, the broken rule, the shortest plan and its last events."""
    plan = shortest.plan
    lines = [f"seed {plan.seed}: {outcome.error}", f"shortest scenario: {shortest.error}"]
    lines += [f"  {gateway}" for gateway in plan.gateways]
    used = {program.line for program in plan.programs}
    lines += [f"  {line}" for line in plan.lines if line.name in used or line.name.startswith("server")]
    for program in plan.programs:
        for number, life in enumerate(program.lives):
            lines.append(f"  {program.line}, life {number}: reconnect={life.reconnect}, close_after={life.close_after}")
            lines += [f"    task {place}: {_steps(task)}" for place, task in enumerate(life.tasks)]
    lines += [f"  all gateways are nodes at {plan.baud} baud"] * (plan.baud is not None)
    lines += [f"  {fault}" for fault in plan.faults]
    lines += [f"  {mishap}" for mishap in plan.mishaps]
    lines.append("events:")
    lines += [_event(entry) for entry in shortest.trace[-MOST_EVENTS:]]
    return "\n".join(lines)


def _steps(steps: tuple[Step, ...]) -> str:
    return "; ".join(f"{step.kind}{step.args}" for step in steps)[:600]


def _event(entry: tuple[object, ...]) -> str:
    when, *what = entry
    return f"  {when:.6f} {' '.join(str(word) for word in what)}"[:200]


def _shorter(items: tuple[T, ...]) -> Iterator[tuple[T, ...]]:
    """Yield sequences with a piece left out, large pieces first."""
    size = len(items)
    while size:
        for start in range(0, len(items), size):
            yield items[:start] + items[start + size :]
        size //= 2


def _cuts(plan: Plan) -> Iterator[Plan]:
    for programs in _shorter(plan.programs):
        if programs:
            yield plan._replace(programs=programs)
    for faults in _shorter(plan.faults):
        yield plan._replace(faults=faults)
    for mishaps in _shorter(plan.mishaps):
        yield plan._replace(mishaps=mishaps)
    for place, program in enumerate(plan.programs):
        for shorter in _cut_program(program):
            yield plan._replace(programs=(*plan.programs[:place], shorter, *plan.programs[place + 1 :]))


def _cut_program(program: ProgramPlan) -> Iterator[ProgramPlan]:
    for lives in _shorter(program.lives):
        if lives:
            yield program._replace(lives=lives)
    for place, life in enumerate(program.lives):
        for shorter in _cut_life(life):
            yield program._replace(lives=(*program.lives[:place], shorter, *program.lives[place + 1 :]))


def _cut_life(life: Life) -> Iterator[Life]:
    for tasks in _shorter(life.tasks):
        yield life._replace(tasks=tasks)
    if life.close_after is not None:
        yield life._replace(close_after=None)
    for place, task in enumerate(life.tasks):
        for steps in _cut_task(task):
            yield life._replace(tasks=(*life.tasks[:place], steps, *life.tasks[place + 1 :]))


def _cut_task(task: tuple[Step, ...]) -> Iterator[tuple[Step, ...]]:
    yield from _shorter(task)
    for place, step in enumerate(task):
        if step.kind == "burst":
            for inner in _shorter(step.args[0]):
                yield (*task[:place], step._replace(args=(inner,)), *task[place + 1 :])
