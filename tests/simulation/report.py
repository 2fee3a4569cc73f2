"""Counts of runs and injected faults over many scenarios."""

from __future__ import annotations

import json
import statistics
import time
from collections import Counter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from simulation.world import Outcome


class Report:
    """Figures of scenarios."""

    def __init__(self) -> None:
        self.scenarios: dict[str, list[int]] = {name: [] for name in ("requests", "programs", "faults", "sessions")}
        """Counts for each scenario: requests sent, programs, injected faults, changes of session."""
        self.injected: Counter[str] = Counter()
        self.failed: list[int] = []
        self._began = time.process_time()

    def add(self, outcome: Outcome) -> None:
        """Add one scenario."""
        self.injected += outcome.injected
        self.scenarios["requests"].append(outcome.requests)
        self.scenarios["programs"].append(len(outcome.plan.programs))
        self.scenarios["faults"].append(sum(outcome.injected.values()))
        self.scenarios["sessions"].append(outcome.sessions)
        if outcome.error is not None:
            self.failed.append(outcome.plan.seed)

    def json(self) -> str:
        """Return the report for `Report.of`."""
        return json.dumps({"scenarios": self.scenarios, "injected": self.injected, "failed": self.failed})

    @classmethod
    def of(cls, parts: list[dict[str, Any]]) -> Report:
        """Return one report of several."""
        report = cls()
        for part in parts:
            report.injected += Counter(part["injected"])
            report.failed += part["failed"]
            for name, values in part["scenarios"].items():
                report.scenarios[name] += values
        return report

    def medians(self) -> dict[str, float]:
        """Return the median of each figure of a scenario."""
        return {name: statistics.median(values) for name, values in self.scenarios.items()}

    def text(self) -> str:
        """Return the report as text."""
        count = len(self.scenarios["requests"])
        spent = time.process_time() - self._began
        most = max(self.injected.values(), default=1)
        lines = [f"{count} scenarios, {len(self.failed)} failed, {1000 * spent / count:.1f} ms of processor time each"]
        lines.append(
            "the median scenario has " + ", ".join(f"{value:g} {name}" for name, value in self.medians().items())
        )
        lines += [
            f"{kind:>8} {number:7} {'#' * round(50 * number / most)}" for kind, number in self.injected.most_common()
        ]
        return "\n".join(lines)
