# What the code counts for its statistics can be read.
s/private:/public:/
