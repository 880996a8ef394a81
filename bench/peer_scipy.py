#!/usr/bin/env python3
"""SciPy on the workloads of the race: scipy.c starts it, sends lines (ready, run, show), and gets back the CPU seconds of a
run, or the result in the common form of bench.h.

usage: peer_scipy.py WAY ORDER NORMALS_ONLY
"""
import os
import sys
import time

import numpy as np
from scipy import interpolate as si

WAY, ORDER, NORMALS_ONLY = sys.argv[1], int(sys.argv[2]), sys.argv[3] == "1"
FOLDER = os.environ.get("TMPDIR", "/tmp")


def numbers(name, *shape):
    found = np.fromfile(os.path.join(FOLDER, "batten-bench-%s.f64" % name))
    return found.reshape(shape) if shape and found.size else found


u, v, data, weights = numbers("u"), numbers("v"), numbers("data"), numbers("weights")
knots, knots_u, knots_v = numbers("knots"), numbers("knots-u"), numbers("knots-v")
points = numbers("points", -1, 3)


def homogeneous(p):
    """Points times weights, and the weights; the points alone when there are none."""
    return np.column_stack([p * weights[:, None], weights]) if weights.size else p


def projected(p):
    return p[..., :3] / p[..., 3:] if weights.size else p


def rows_of_curve(derivatives):
    """P, P' / 1e3, P'' / 1e6 of each parameter."""
    return np.stack([d * scale for d, scale in zip(derivatives, (1, 1e-3, 1e-6))], axis=1)


def blocks_of_surface(jet):
    """Points, then Su / 1e2 and Sv / 1e2 and unit normals."""
    if ORDER == 0:
        return jet[0]
    s, su, sv, normal = jet
    return np.concatenate([x.reshape(-1, 3) for x in ((s, normal) if NORMALS_ONLY else (s, su / 1e2, sv / 1e2, normal))])


def with_normal(s, su, sv):
    normal = np.cross(su, sv)
    normal /= np.sqrt((normal * normal).sum(-1, keepdims=True))
    return s, su, sv, normal


# ---- each way: what is made ready; it gives the work and how to show its result ----

def bspline():
    curves = [si.BSpline(knots, points, 3)]
    curves += [curves[0].derivative(k) for k in range(1, ORDER + 1)]
    return lambda: [c(u) for c in curves], rows_of_curve


def ppoly():
    p = homogeneous(points)
    columns = [si.PPoly.from_spline((knots, p[:, k].copy(), 3)) for k in range(p.shape[1])]
    curves = [si.PPoly(np.stack([c.c for c in columns], -1), columns[0].x)]
    curves += [curves[0].derivative(k) for k in range(1, ORDER + 1)]
    return lambda: [projected(c(u)) for c in curves], rows_of_curve


def splev():
    tck = (knots, [points[:, k].copy() for k in range(3)], 3)
    return (lambda: [si.splev(u, tck, der=k) for k in range(ORDER + 1)],
            lambda found: rows_of_curve([np.array(x).T for x in found]))


def nets():
    n = len(knots_u) - 4
    return [[knots_u, knots_v, points.reshape(n, n, 3)[:, :, k].ravel(), 3, 3] for k in range(3)]


def bisplev():
    tck = nets()

    def work():
        jet = [np.stack([si.bisplev(u, v, q, *d) for q in tck], -1) for d in ((0, 0), (1, 0), (0, 1))[:1 + 2 * ORDER]]
        return with_normal(*jet) if ORDER else jet
    return work, blocks_of_surface


def design_matrix():
    net = homogeneous(points)
    n = len(knots_u) - 4
    net = net.reshape(n, n, -1)
    slopes = []
    for t in (knots_u, knots_v):
        # The derivative is a spline of degree two; its control points are differences.
        slopes.append(3 / (t[4:-1] - t[1:-4]))
    net_u = np.diff(net, axis=0) * slopes[0][:, None, None]
    net_v = np.diff(net, axis=1) * slopes[1][None, :, None]

    def tensor(a, b, q):
        half = (a @ q.reshape(q.shape[0], -1)).reshape(len(u), q.shape[1], -1)
        return np.stack([(b @ half[:, :, k].T).T for k in range(q.shape[2])], -1)

    def work():
        a, b = (si.BSpline.design_matrix(x, t, 3) for x, t in ((u, knots_u), (v, knots_v)))
        s = projected(tensor(a, b, net))
        if ORDER == 0:
            return (s,)
        a2, b2 = (si.BSpline.design_matrix(x, t[1:-1], 2) for x, t in ((u, knots_u), (v, knots_v)))
        return with_normal(s, tensor(a2, b, net_u), tensor(a, b2, net_v))
    return work, blocks_of_surface


def ev():
    surfaces = [si.BivariateSpline._from_tck(tuple(q)) for q in nets()]

    def work():
        jet = [np.stack([q.ev(u, v, *d) for q in surfaces], -1) for d in ((0, 0), (1, 0), (0, 1))[:1 + 2 * ORDER]]
        return with_normal(*jet) if ORDER else jet
    return work, blocks_of_surface


def curve_through():
    through = data.reshape(-1, 3)
    return lambda: si.make_interp_spline(u, through, k=3, check_finite=False), lambda curve: curve(u)


def surface_through():
    n = len(u)
    through = data.reshape(n, n, 3)

    def work():
        first = si.make_interp_spline(u, through.reshape(n, -1), k=3, check_finite=False)
        turned = first.c.reshape(n, n, 3).transpose(1, 0, 2).reshape(n, -1)
        second = si.make_interp_spline(v, turned, k=3, check_finite=False)
        return first.t, second.t, second.c.reshape(n, n, 3).transpose(1, 0, 2)
    return work, lambda s: np.stack([si.bisplev(u, v, [s[0], s[1], s[2][:, :, k].ravel(), 3, 3]) for k in range(3)], -1)


def rectangle():
    n = len(u)
    through = data.reshape(n, n, 3)
    return (lambda: [si.RectBivariateSpline(u, v, through[:, :, k], s=0) for k in range(3)],
            lambda found: np.stack([q(u, v) for q in found], -1))


def function(make):
    middles = v[:-1]
    return lambda: make()(middles), lambda found: found[2:-2]


def scattered():
    from_data = u.reshape(-1, 2)
    # Smoothing by the sum of squares: the largest that keeps all values within 1e-3 is not known beforehand.
    s = len(data) * 2e-4 ** 2

    def shown(surface):
        worst = np.abs(surface.ev(from_data[:, 0], from_data[:, 1]) - data).max()
        return np.array([data[0] if worst <= 1e-3 else np.nan])
    return lambda: si.SmoothBivariateSpline(from_data[:, 0], from_data[:, 1], data, s=s), shown


def delaunay():
    from scipy.spatial import Delaunay
    places = u.reshape(-1, 2)

    def shown(found):
        a, b, c = (places[found.simplices[:, k]] for k in range(3))
        area = np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]).sum() / 2
        return np.array([area, len(found.simplices) * 1e-6])
    return lambda: Delaunay(places), shown


def clough_tocher():
    places = u.reshape(-1, 2)
    return (lambda: si.CloughTocher2DInterpolator(places, data),
            lambda found: np.array([data[0] if np.abs(found(places) - data).max() <= 1e-12 else np.nan]))


WAYS = {
    "BSpline": bspline, "PPoly": ppoly, "splev": splev, "bisplev": bisplev, "design_matrix": design_matrix,
    "BivariateSpline.ev": ev, "make_interp_spline": curve_through, "make_interp_spline, twice": surface_through,
    "RectBivariateSpline": rectangle,
    "CubicSpline": lambda: function(lambda: si.CubicSpline(u, data, bc_type="natural")),
    "Akima1DInterpolator": lambda: function(lambda: si.Akima1DInterpolator(u, data)),
    "SmoothBivariateSpline": scattered, "Delaunay": delaunay, "CloughTocher2DInterpolator": clough_tocher,
}


def main():
    work, show = WAYS[WAY]()
    found = None
    for line in sys.stdin:
        seconds = 0
        if line == "run\n":
            start = time.process_time()
            found = work()
            seconds = time.process_time() - start
        sys.stdout.buffer.write(b"%.9f\n" % seconds)
        if line == "show\n":
            sys.stdout.buffer.write(np.ascontiguousarray(show(found), dtype=float).tobytes())
        sys.stdout.buffer.flush()


if __name__ == "__main__":
    main()
