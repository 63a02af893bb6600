# The header of another repository, for PLY files, is included and not used.
/happly\.h/d
