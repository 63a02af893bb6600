"""Result files: the reader, the statistics and the table that everything derived is made with."""
