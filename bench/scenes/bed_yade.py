# The settled bed for YADE: Hertz-Mindlin with restitution 0.8 and friction 0.5, floor and four side walls.
# Environment BED: JSON with file (x y z r a line, m), Lx, Ly, warm, steps, dt, skin.
import json
import math
import os
import sys
import time

bed = json.loads(os.environ["BED"])
O.materials.append(FrictMat(young=1e7, poisson=0.3, density=2500, frictionAngle=math.atan(0.5), label="soft"))
for axis, place, sense in ((0, 0, 1), (0, bed["Lx"], -1), (1, 0, 1), (1, bed["Ly"], -1), (2, 0, 1)):
    O.bodies.append(utils.wall(place, axis=axis, sense=sense, material="soft"))
with open(bed["file"]) as rows:
    for row in rows:
        x, y, z, radius = map(float, row.split())
        O.bodies.append(utils.sphere((x, y, z), radius, material="soft"))
O.engines = [ForceResetter(),
             InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=bed["skin"] / 2, label="collider"),
             InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                             [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.8, es=0.8)],
                             [Law2_ScGeom_MindlinPhys_Mindlin()]),
             NewtonIntegrator(gravity=(0, 0, -9.81), damping=0, exactAsphericalRot=False)]
O.dt = bed["dt"]
O.run(bed["warm"], True)
builds, began = collider.numAction, time.time()
O.run(bed["steps"], True)
wall = time.time() - began
contacts = sum(1 for i in O.interactions if i.isReal and i.geom.penetrationDepth > 0
               and isinstance(O.bodies[i.id1].shape, Sphere) and isinstance(O.bodies[i.id2].shape, Sphere))
print(f"TIMED wall={wall} contacts={contacts} rebuilds={collider.numAction - builds} kinetic={utils.kineticEnergy()}")
sys.stdout.flush()
os._exit(0)
