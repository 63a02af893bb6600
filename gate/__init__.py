"""The performance gate: does a revision give right answers, at no higher price than its base?

`python -m gate`, or rather ./check_performance.sh; docs/regression-gate.md describes the levels.
"""
