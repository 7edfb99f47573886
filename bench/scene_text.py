"""Parts of scenes that benches share."""

# Nothing is written but final.csv and summary.json.
QUIET = """[output]
vtk = false
hdf5 = false
picture = false
walls = false
"""
# The material of the settled beds of spheres.
SOFT = """[[material]]
name = "soft"
young = 1e7
poisson = 0.3
density = 2500
restitution = 0.8
friction = 0.5
"""
