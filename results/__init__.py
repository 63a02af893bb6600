"""Result files: the reader, and the statistics and tables for all derived output."""
