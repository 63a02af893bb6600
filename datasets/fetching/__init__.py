"""What datasets/fetch.py is made of: the manifest, the cache, and where meshes come from."""
