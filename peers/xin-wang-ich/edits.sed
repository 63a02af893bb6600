# Windows are counted when they are propagated too, by the adapter's counter; the code counts those
# that are queued.
s/\bComputeChildrenOfWindow\(quoteW\)/++propagated_windows, &/
