"""Verdicts over result files: comparing runs, ranking a solver, gating a change.

`python -m gate` is the gate itself, ./check_performance.sh; docs/regression-gate.md describes it.
"""
