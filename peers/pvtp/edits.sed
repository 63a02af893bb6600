# Neither header is there: the adapter has what they are included for.
s/#include (<windows\.h>|"tbb\/task_scheduler_init\.h")//
# The standard asks for the word; Visual Studio does not.
s/\((ListGroup<BinItem>::ListItem)/(typename \1/g
# oneTBB has no atomics.
s/\btbb::atomic\b/std::atomic/g
# An atomic cannot be passed to printf.
s/m_windows_propagation([,)])/m_windows_propagation.load()\1/g
# Members that other files use are commented out.
s/\/\/(double&? *m?_?(shortest_distance|incident_point)\b)/\1/g
# The filter of windows reads it and nothing sets it: avtp solved or did not end by what lay in
# memory. On the fresh stack of a small program it is 0.
s/\beps_ICH;/eps_ICH = 0;/
