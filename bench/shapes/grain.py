"""One grain from X-ray tomography, at any fidelity: from the coefficients of its surface r(theta, phi) = sum a_nm Y_nm
(bench/data/grain_sacci425_01.dat) to hulls with a given number of vertices, an ellipsoid, a clump of spheres."""
import cmath
import math
import os

COEFFICIENTS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "data", "grain_sacci425_01.dat")


def directions(count):
    """Unit vectors spread evenly over the sphere (Fibonacci's spiral)."""
    golden = math.pi * (3 - math.sqrt(5))
    rows = []
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        s = math.sqrt(1 - z * z)
        rows.append((s * math.cos(golden * i), s * math.sin(golden * i), z))
    return rows


def legendre(degree, x):
    """P[n][m]: associated Legendre functions with the orthonormal factor of Y_nm and Condon and Shortley's sign."""
    s = math.sqrt(max(0.0, 1 - x * x))
    p = [[0.0] * (n + 1) for n in range(degree + 1)]
    p[0][0] = math.sqrt(1 / (4 * math.pi))
    for m in range(1, degree + 1):
        p[m][m] = -math.sqrt((2 * m + 1) / (2 * m)) * s * p[m - 1][m - 1]
    for m in range(degree):
        p[m + 1][m] = math.sqrt(2 * m + 3) * x * p[m][m]
        for n in range(m + 2, degree + 1):
            a = math.sqrt((4 * n * n - 1) / (n * n - m * m))
            b = math.sqrt(((n - 1) ** 2 - m * m) / (4 * (n - 1) ** 2 - 1))
            p[n][m] = a * (x * p[n - 1][m] - b * p[n - 2][m])
    return p


def surface(count):
    """Points on the grain's surface in `count` directions, in the file's unit of length."""
    with open(COEFFICIENTS, encoding="ascii") as file:
        a = {}
        for line in file:
            n, m, real, imaginary = line.split()
            a[int(n), int(m)] = complex(float(real), float(imaginary))
    degree = max(n for n, _ in a)
    points = []
    for u in directions(count):
        p = legendre(degree, u[2])
        phi = math.atan2(u[1], u[0])
        r = sum((a[n, m] * p[n][m] * cmath.exp(1j * m * phi)).real * (1 if m == 0 else 2)
                for n in range(degree + 1) for m in range(n + 1) if (n, m) in a)
        points.append(tuple(r * c for c in u))
    return points


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def hull_vertices(points, count):
    """`count` of the points whose convex hull is near that of all: one by one the point that the hull of those before
    misses by most, over 3000 directions. Fewer when they reach all."""
    looks = directions(3000)
    far = [max(points, key=lambda p, u=u: dot(p, u)) for u in looks]
    reach = [dot(p, u) for p, u in zip(far, looks)]
    chosen, now = [], [-math.inf] * len(looks)
    new = max(points, key=lambda p: dot(p, p))
    while len(chosen) < count:
        chosen.append(new)
        now = [max(n, dot(new, u)) for n, u in zip(now, looks)]
        worst = max(range(len(looks)), key=lambda i: reach[i] - now[i])
        if reach[worst] <= now[worst]:
            break
        new = far[worst]
    return chosen


def extents(points):
    """Length, width and thickness along the principal axes of the points, taken by power iteration."""
    n = len(points)
    middle = [sum(p[k] for p in points) / n for k in range(3)]
    moved = [tuple(p[k] - middle[k] for k in range(3)) for p in points]
    tensor = [[sum(p[i] * p[j] for p in moved) / n for j in range(3)] for i in range(3)]
    axes = []
    for start in ((1.0, 0.3, 0.2), (0.2, 1.0, 0.3)):
        v = start
        for _ in range(500):
            v = tuple(dot(row, v) for row in tensor)
            for axis in axes:
                along = dot(v, axis)
                v = tuple(v[k] - along * axis[k] for k in range(3))
            size = math.sqrt(dot(v, v))
            v = tuple(c / size for c in v)
        axes.append(v)
    a, b = axes
    axes.append((a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]))
    widths = [max(dot(p, u) for p in moved) - min(dot(p, u) for p in moved) for u in axes]
    return sorted(widths, reverse=True)


def clump(points, count):
    """`count` spheres inside the surface points, one by one the one that holds most of what the others leave empty."""
    surface_points = points[::2]
    inside = [tuple(t * c for c in p) for p in points[::8] for t in (0.35, 0.6, 0.8, 0.95)]
    centres = [tuple(t * c for c in p) for p in points[::16] for t in (0.15, 0.4, 0.6, 0.75)]
    balls = []
    for c in centres:
        radius = min(math.dist(c, p) for p in surface_points)
        balls.append((c, radius, {i for i, q in enumerate(inside) if math.dist(c, q) < radius}))
    left, chosen = set(range(len(inside))), []
    while len(chosen) < count:
        centre, radius, held = max(balls, key=lambda b: (len(b[2] & left), b[1]))
        left -= held
        chosen.append((*centre, radius))
    return chosen
