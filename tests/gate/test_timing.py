"""Level 4: the choice of the timed rows, and the decisions from pairs. No test depends on a clock."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from gate_world import Change, World, fact, first, unchanged, with_valgrind
from results.columns import Columns
from results.pairs import Pairs, interleaved
from results.reader import Cell, Row
from results.statistics import Decision

from gate import code as gate_code
from gate import revisions, timing
from gate.findings import GOOD, NOT_RESOLVED, REGRESSION, GateError, Weight
from gate.measured import Measured
from gate.program import Verified
from gate.timing import PAIRS, Timing, timed_cells
from gate.verdict import Verdict, as_text, judge

A, B, C = (Cell("mmp", mesh, 0) for mesh in ("cube", "hill", "torus"))


def made(ratio: float, spread: float, seed: int, pairs: int = PAIRS) -> Pairs:
    """Returns pairs whose ratios scatter around `ratio`. Both times have the same drift."""
    random = np.random.default_rng(seed)
    base = 20 * np.exp(np.linspace(0, 0.5, pairs))
    head = base * ratio * np.exp(random.normal(0, spread, pairs))
    return Pairs(base.tolist(), head.tolist())


def verdict_of(timed: Timing, strict: bool = False) -> Verdict:
    return judge("base", "head", [timing.report(timed, "larger --budget")], strict)


class Machine:
    """A machine on which the head takes `ratios` times the base's time."""

    def __init__(self, ratios: dict[Cell, float], spread: float, seed: int = 0) -> None:
        self.ratios, self.spread, self.seed = ratios, spread, 1000 * seed
        self.sessions: list[list[Cell]] = []

    def session(self, cells: Sequence[Cell]) -> dict[Cell, Pairs]:
        self.sessions.append(list(cells))
        self.seed += len(cells)
        return {
            cell: made(self.ratios[cell], self.spread, self.seed + i)
            for i, cell in enumerate(cells)
        }

    def verdict(self, most: int = 6, **options: Any) -> Verdict:
        """@param most largest number of sessions"""
        timed = Timing(1.1, options.get("grown", {}))
        timed.add(self.session(list(self.ratios)))
        while (suspects := timed.suspects()) and len(self.sessions) < most:
            timed.add(self.session(suspects))
        return verdict_of(timed, options.get("strict", False))


@pytest.mark.parametrize("spread", [0.01, 0.04, 0.1])
def test_equals_are_never_a_regression_and_mostly_good(spread: float) -> None:
    words = [Machine({A: 1, B: 1, C: 1}, spread, seed).verdict().word for seed in range(10)]
    assert "REGRESSION" not in words
    assert words.count("good") >= (10 if spread < 0.1 else 6)


def test_15_percent_is_found() -> None:
    verdicts = [Machine({A: 1.15, B: 1.15, C: 1.15}, 0.04, seed).verdict() for seed in range(20)]
    assert sum(verdict.exit_code == REGRESSION for verdict in verdicts) >= 19
    assert all(verdict.word != "good" for verdict in verdicts)


@pytest.mark.parametrize("spread", [0.02, 0.04, 0.08])
def test_8_percent_is_never_good(spread: float) -> None:
    for seed in range(5):
        verdict = Machine({A: 1.08, B: 1.08, C: 1.08}, spread, seed).verdict()
        assert verdict.word in ("NOT RESOLVED", "SLOWER WITHIN THE MARGIN", "REGRESSION")


def test_a_single_slower_row_is_found() -> None:
    machine = Machine({A: 1.2, B: 1.0, C: 1.0}, 0.03)
    verdict = machine.verdict()
    assert verdict.exit_code == REGRESSION
    assert first(verdict).startswith("mmp/cube/src:0: 1.19")
    assert machine.sessions[1:] == [[A]] * (len(machine.sessions) - 1)


def test_a_slower_row_is_measured_in_a_second_session() -> None:
    machine = Machine({A: 1.5}, 0.02)
    assert machine.verdict().exit_code == REGRESSION
    assert machine.sessions == [[A], [A]]


def test_a_slower_row_needs_no_second_session_when_a_counter_has_grown() -> None:
    machine = Machine({A: 1.5}, 0.02)
    verdict = machine.verdict(grown={"mmp": 1})
    assert verdict.exit_code == REGRESSION and len(machine.sessions) == 1
    assert first(verdict).endswith("15 pairs; level 1 has grown as well")


def test_a_median_above_the_margin_is_not_resolved_when_the_budget_is_spent() -> None:
    machine = Machine({A: 1.12}, 0.1)
    verdict = machine.verdict(most=1)
    assert verdict.exit_code == GOOD
    assert as_text(verdict).startswith("NOT RESOLVED: head against base\n")
    assert "larger --budget" in first(verdict) and "times as long [" in first(verdict)
    assert Machine({A: 1.12}, 0.1).verdict(most=1, strict=True).exit_code == NOT_RESOLVED


@pytest.mark.parametrize(("spread", "decision"), [(0.01, Decision.SAME), (0.08, Decision.UNDECIDED)])
def test_an_interval_below_the_margin_is_undecided_if_half_the_margin_fits_in(
    spread: float, decision: Decision
) -> None:
    timed = Timing(1.1, {})
    ratios = [1 - spread, 1.0, 1 + spread] * (PAIRS // 3)
    timed.add({A: Pairs([1.0] * len(ratios), ratios)})
    assert timed.decision(A) == decision


def test_a_solver_that_is_slower_on_the_mean_is_a_regression() -> None:
    """The noise of each single row is too large."""
    timed = Timing(1.1, {})
    for _ in range(2):
        timed.add({A: made(1.2, 0.15, 1), B: made(1.2, 0.15, 2), C: made(1.2, 0.15, 3)})
    assert timed.mean_decision("mmp") == Decision.SLOWER
    verdict = verdict_of(timed)
    assert first(verdict).startswith("mmp, geometric mean over 3 rows: 1.")
    assert timed.suspects() == []


def test_rows_of_suitable_length_are_timed_and_three_of_each_solver() -> None:
    def row(solver: str, milliseconds: float) -> Measured:
        cell = Cell(solver, f"{milliseconds:g}", 0)
        return Measured(cell, [of(cell, milliseconds)])

    rows = [row("a", t) for t in (1, 9, 11, 50, 149, 151)]
    rows += [row("b", t) for t in (1, 3, 9, 20, 200)] + [row("c", t) for t in (0.1, 200, 300)]
    chosen = [f"{cell.solver} {cell.mesh}" for cell in timed_cells(rows)]
    assert chosen == ["a 11", "a 50", "a 149", "b 3", "b 9", "b 20", "c 0.1", "c 200", "c 300"]


def of(cell: Cell, milliseconds: float, repetition: int = 0, **numbers: float) -> Row:
    columns = Columns.of([{"outcome": "ok", "cpu_time": milliseconds, **numbers}])
    return Row(cell.solver, cell.mesh, cell.source, repetition, "ok", "", None, None, None, "", columns, 0)


def test_pairs_are_of_one_repetition_and_disturbed_ones_are_left_out() -> None:
    first_side = [of(A, 10 + r, r) for r in range(12)]
    second_side = [of(A, 20 + 2 * r, r) for r in range(1, 12)]
    second_side[0] = of(A, 99, 1, stolen_share=0.02)
    second_side[1] = of(A, 99, 2, involuntary_switches_per_s=501)
    pairs = interleaved(first_side, second_side)
    assert pairs.ratios == [2.0] * 9 and pairs.disturbed == 2
    few = interleaved(first_side[:5], second_side)
    assert len(few) == 4, "too few others: all are used"


def test_time_fails_only_above_the_margin(world: World) -> None:
    assert world.gate(fact("mmp", "cpu_ms", 52.0), levels=(4,)).word == "good"
    assert world.gate(fact("mmp", "cpu_ms", 54.0), levels=(4,)).word == "SLOWER WITHIN THE MARGIN"
    verdict = world.gate(fact("mmp", "cpu_ms", 56.0), levels=(4,))
    assert verdict.exit_code == REGRESSION
    assert first(verdict) == (
        "mmp, geometric mean over 2 rows: 1.120 times as long [1.120, 1.120]"
    )
    assert [path.name for path in sorted(world.options.out.glob("time-*"))] == ["time-1", "time-2"]


def test_when_a_row_has_failed_rows_that_are_not_decided_are_measured_only_if_all_are_asked_for(
    world: World,
) -> None:
    def change(head: dict[str, Any]) -> None:
        fact("mmp", "cpu_ms", 60.0)(head)
        fact("ich", "cpu_ms", [25.0, 45.0, 30.0])(head)

    verdict = world.gate(change, levels=(4,))
    assert verdict.exit_code == REGRESSION and world.measured == {"timed processes": 8 * 30}
    [text, _] = [f.line for f in verdict.findings if f.weight == Weight.NOT_RESOLVED]
    assert text.endswith("30 pairs: not measured further, since the verdict is certain (--all measures on)")

    machine = timing.Timing(1.1, {}, everything=True)
    machine.add({A: made(1.5, 0.01, 1), B: made(1.0, 0.3, 2)})
    machine.add({A: made(1.5, 0.01, 3)})
    assert machine.decision(A) == Decision.SLOWER and B in machine.suspects()
    assert not machine.certain and replace(machine, everything=False).certain


def test_noise_that_hides_the_margin_is_not_resolved(world: World) -> None:
    def noisy(one: dict[str, Any]) -> None:
        one["switches"] = 900.0

    def noisy_and_slow(head: dict[str, Any]) -> None:
        noisy(head)
        fact("mmp", "cpu_ms", [50.0, 80.0, 50.0, 60.0, 50.0])(head)

    verdict = world.gate(noisy_and_slow, noisy, levels=(4,), budget=0.0)
    assert verdict.word == "NOT RESOLVED" and verdict.exit_code == GOOD
    assert "15 pairs, 15 disturbed" in first(verdict)
    assert as_text(verdict).count("larger --budget") == 1, "one remark for both rows"
    assert "15 disturbed; mmp/hill/src:0: 1.0" in as_text(verdict)


def code(folder: str, machine_code: str = "another") -> Change:
    return lambda world: world["objects"].update({folder: machine_code})


ROWS = 2 * 2 * PAIRS
"""Number of processes of a session of one solver, on two meshes."""


@pytest.mark.parametrize(
    ("change", "timed"),
    [
        (unchanged, 0),
        (code("mmp"), ROWS),
        (fact("mmp", "instructions", 1_004_999), 0),
        (fact("mmp", "instructions", 1_010_000), ROWS),
        (fact("mmp", "instructions", 900_000), ROWS),
        (fact("mmp", "propagations", 10_010), ROWS),
        (fact("mmp", "propagations", 9_000), ROWS),
        (code("CMakeFiles"), 2 * ROWS),
        (code("chen_han"), ROWS),
        (code("variants"), 0),
    ],
    ids=["nothing", "code", "noise of counts", "instructions", "fewer instructions", "counters",
         "lower counters", "shared code", "another solver", "a variant"],
)  # fmt: skip
def test_only_solvers_whose_code_counters_or_instructions_changed_are_timed(
    world: World, monkeypatch: pytest.MonkeyPatch, change: Change, timed: int
) -> None:
    with_valgrind(monkeypatch)
    verdict = world.gate(change, levels=(0, 1, 2, 3, 4))
    assert verdict.exit_code == GOOD and world.measured["timed processes"] == timed
    assert verdict.levels[4].compared == timed // (2 * PAIRS)
    assert ("not timed: nothing changed" in as_text(verdict)) == (timed < 2 * ROWS)
    assert not any(finding.weight == Weight.NOT_RESOLVED for finding in verdict.findings)


def test_solvers_that_did_not_change_are_timed_if_all_are_asked_for_or_their_instructions_are_unknown(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    world.gate(levels=(0, 1, 3, 4))
    assert world.measured == {"timed processes": 2 * ROWS}
    with_valgrind(monkeypatch)
    world.gate(levels=(0, 1, 2, 3, 4), everything=True)
    assert world.measured["timed processes"] == 4 * ROWS


def test_15_percent_in_one_solver_time_that_solver_only(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two sessions confirm it. The rows of the other solver are too noisy for any decision."""
    with_valgrind(monkeypatch)
    noisy = fact("ich", "cpu_ms", [20.0, 50.0, 25.0, 60.0, 20.0])

    def slower(head: dict[str, Any]) -> None:
        noisy(head)
        fact("mmp", "cpu_ms", 57.5)(head)
        code("mmp")(head)

    verdict = world.gate(slower, noisy, levels=(0, 1, 2, 3, 4))
    assert verdict.exit_code == REGRESSION and first(verdict).startswith("mmp, geometric mean over 2 rows: 1.150")
    assert world.measured["timed processes"] == 2 * ROWS


def test_a_solver_that_no_family_registers_is_unchanged_only_if_all_code_is(world: World) -> None:
    head = world.program("head", code("chen_han")).path.parent
    base, same = world.program("base").path.parent, world.program("same").path.parent
    solvers = {"mmp?threads=2", "ich", "steiner"}
    assert gate_code.unchanged(base, same, world.folder, solvers) == solvers
    assert gate_code.unchanged(base, head, world.folder, solvers) == {"mmp?threads=2"}
    (same / "compile_commands.json").unlink()
    assert gate_code.unchanged(same, same, world.folder, solvers) == set()


def test_a_program_that_fails_when_it_is_timed_is_an_error(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("gate.revisions.verify", lambda program, options: Verified(
        None, {A: Measured(A, [of(A, 20)])}))  # fmt: skip
    with pytest.raises(GateError, match="mmp/cube/src:0: the head failed when timed: crashed"):
        world.gate(fact("mmp", "outcome", "crashed"), levels=(4,))


def test_a_build_against_itself_reports_its_noise_and_keeps_it(
    world: World, tmp_path: Path
) -> None:
    kept = tmp_path / "noise.json"
    options = replace(world.options, noise_file=kept)
    verdict = revisions.against_itself(world.program("head"), 2, options)
    assert verdict.exit_code == GOOD and verdict.levels[0].compared == 4
    assert verdict.levels[0].table[0][2:] == ["0.0%", "1.000 to 1.000", "1.000 to 1.000", "0 of 2"]
    noise = {str(A): timing.noise(made(1, 0.04, 5, 1000))}
    assert noise[str(A)] == pytest.approx(1.04, abs=0.004)
    timing.keep_noise(kept, "fake", noise)
    timing.check_margin(kept, "fake", [A], 1.05)
    timing.check_margin(kept, "another processor", [A], 1.01)
    with pytest.raises(GateError, match="below this machine's noise of mmp/cube/src:0, 1.0"):
        timing.check_margin(kept, "fake", [A], 1.02)


def test_a_build_that_is_slower_than_itself_is_a_failure() -> None:
    machine = Machine({A: 1.3}, 0.02)
    result, _ = timing.against_itself([A], machine.session, 2, 1.1, lambda line: None)
    assert result.findings[0].weight == Weight.FAILURE
    assert result.findings[0].line == "mmp/cube/src:0: slower than itself"
