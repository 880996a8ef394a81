// Open CASCADE on the workloads: plain calls, and adaptors that keep the last span; the faster counts.
#include "bench.h"

#include <GCPnts_AbscissaPoint.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

struct Knots {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger times;
    explicit Knots(int n) : values(1, n), times(1, n)
    {
    }
};

Knots knots_of(const double *knots, int count, int degree)
{
    const int all = count + degree + 1;
    int distinct = 0, at = 0;
    for (int i = 0; i < all; i++)
        distinct += i == 0 || knots[i] != knots[i - 1];
    Knots made(distinct);
    for (int i = 0; i < all; i++) {
        if (i == 0 || knots[i] != knots[i - 1]) {
            made.values(++at) = knots[i];
            made.times(at) = 0;
        }
        made.times(at)++;
    }
    return made;
}

struct Contest {
    const bench_work *work;
    Handle(Geom_BSplineCurve) curve;
    Handle(Geom_BSplineSurface) surface;
    std::vector<gp_Pnt> points;
    std::vector<gp_Vec> first, second, normals;
    double length = 0;
};

void *open_curve(const bench_work *work)
{
    auto *c = new Contest{work, {}, {}, {}, {}, {}, {}, 0};
    const bench_curve &from = work->curve;
    const Knots knots = knots_of(from.knots, from.count, from.degree);
    TColgp_Array1OfPnt points(1, from.count);
    TColStd_Array1OfReal weights(1, from.count);
    for (int i = 0; i < from.count; i++) {
        const double *p = from.points + 3 * i;
        points(i + 1) = gp_Pnt(p[0], p[1], p[2]);
        weights(i + 1) = from.weights ? from.weights[i] : 1;
    }
    c->curve =
        from.weights
            ? new Geom_BSplineCurve(points, weights, knots.values, knots.times, from.degree)
            : new Geom_BSplineCurve(points, knots.values, knots.times, from.degree);
    c->points.resize(work->count);
    c->first.resize(work->count);
    c->second.resize(work->count);
    return c;
}

void *open_surface(const bench_work *work)
{
    auto *c = new Contest{work, {}, {}, {}, {}, {}, {}, 0};
    const bench_surface &from = work->surface;
    const int n = from.count;
    const Knots u = knots_of(from.knots[0], n, from.degree),
                v = knots_of(from.knots[1], n, from.degree);
    TColgp_Array2OfPnt points(1, n, 1, n);
    TColStd_Array2OfReal weights(1, n, 1, n);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            const double *p = from.points + 3 * (i * n + j);
            points(i + 1, j + 1) = gp_Pnt(p[0], p[1], p[2]);
            weights(i + 1, j + 1) = from.weights ? from.weights[i * n + j] : 1;
        }
    const int p = from.degree;
    c->surface = from.weights ? new Geom_BSplineSurface(points, weights, u.values, v.values,
                                                        u.times, v.times, p, p)
                              : new Geom_BSplineSurface(points, u.values, v.values, u.times,
                                                        v.times, p, p);
    const size_t count = work->kind == SURFACE_GRID ? work->count * work->count : work->count;
    c->points.resize(count);
    c->first.resize(count);
    c->second.resize(count);
    c->normals.resize(count);
    return c;
}

void close_contest(void *object)
{
    delete static_cast<Contest *>(object);
}

template <class Evaluator> void evaluate_curve(Contest *c, const Evaluator &on)
{
    const double *u = c->work->u;
    for (size_t i = 0; i < c->work->count; i++)
        if (c->work->order == 0)
            on.D0(u[i], c->points[i]);
        else
            on.D2(u[i], c->points[i], c->first[i], c->second[i]);
}

void run_curve(void *object)
{
    auto *c = static_cast<Contest *>(object);
    evaluate_curve(c, *c->curve);
}

void run_curve_adaptor(void *object)
{
    auto *c = static_cast<Contest *>(object);
    evaluate_curve(c, GeomAdaptor_Curve(c->curve));
}

void put(const gp_XYZ &from, double scale, double *to)
{
    to[0] = scale * from.X();
    to[1] = scale * from.Y();
    to[2] = scale * from.Z();
}

void gather_curve(void *object, double *result)
{
    auto *c = static_cast<Contest *>(object);
    for (size_t i = 0; i < c->work->count; i++) {
        put(c->points[i].XYZ(), 1, result);
        result += 3;
        if (c->work->order == 0)
            continue;
        put(c->first[i].XYZ(), 1e-3, result);
        put(c->second[i].XYZ(), 1e-6, result + 3);
        result += 6;
    }
}

template <class Evaluator>
void evaluate_surface(Contest *c, const Evaluator &on, size_t i, double u, double v)
{
    if (c->work->order == 0) {
        on.D0(u, v, c->points[i]);
        return;
    }
    on.D1(u, v, c->points[i], c->first[i], c->second[i]);
    c->normals[i] = c->first[i].Crossed(c->second[i]).Normalized();
}

template <class Evaluator> void evaluate_places(Contest *c, const Evaluator &on)
{
    const size_t n = c->work->count;
    if (c->work->kind == SURFACE_GRID)
        for (size_t i = 0; i < n * n; i++)
            evaluate_surface(c, on, i, c->work->u[i / n], c->work->v[i % n]);
    else
        for (size_t i = 0; i < n; i++)
            evaluate_surface(c, on, i, c->work->u[i], c->work->v[i]);
}

void run_surface(void *object)
{
    auto *c = static_cast<Contest *>(object);
    evaluate_places(c, *c->surface);
}

void run_surface_adaptor(void *object)
{
    auto *c = static_cast<Contest *>(object);
    evaluate_places(c, GeomAdaptor_Surface(c->surface));
}

void gather_surface(void *object, double *result)
{
    auto *c = static_cast<Contest *>(object);
    const size_t count = c->points.size();
    for (size_t i = 0; i < count; i++) {
        double jet[9], normal[3];
        put(c->points[i].XYZ(), 1, jet);
        put(c->first[i].XYZ(), 1, jet + 3);
        put(c->second[i].XYZ(), 1, jet + 6);
        put(c->normals[i].XYZ(), 1, normal);
        bench_lay_point(c->work, bench_place{i, count}, jet, normal, result);
    }
}

void *open_data(const bench_work *work)
{
    return new Contest{work, {}, {}, {}, {}, {}, {}, 0};
}

void run_curve_through(void *object)
{
    auto *c = static_cast<Contest *>(object);
    const int n = static_cast<int>(c->work->count);
    Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, n);
    Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, n);
    for (int i = 0; i < n; i++) {
        const double *p = c->work->data + 3 * i;
        points->SetValue(i + 1, gp_Pnt(p[0], p[1], p[2]));
        parameters->SetValue(i + 1, c->work->u[i]);
    }
    GeomAPI_Interpolate interpolate(points, parameters, Standard_False, 1e-15);
    interpolate.Perform();
    if (!interpolate.IsDone()) {
        std::fprintf(stderr, "bench: occt: no curve\n");
        std::exit(1);
    }
    c->curve = interpolate.Curve();
}

void gather_curve_through(void *object, double *result)
{
    auto *c = static_cast<Contest *>(object);
    const GeomAdaptor_Curve on(c->curve);
    for (size_t i = 0; i < c->work->count; i++)
        put(on.Value(c->work->u[i]).XYZ(), 1, result + 3 * i);
}

void run_length(void *object)
{
    auto *c = static_cast<Contest *>(object);
    const GeomAdaptor_Curve curve(c->curve);
    c->length = GCPnts_AbscissaPoint::Length(curve, 1e-9);
}

void gather_length(void *object, double *result)
{
    *result = static_cast<Contest *>(object)->length / 1e3;
}

} // namespace

#define CURVE(name, kind, run)                                            \
    {                                                                     \
        name, kind, open_curve, run, gather_curve, close_contest, nullptr \
    }
#define SURFACE(name, kind, run)                                              \
    {                                                                         \
        name, kind, open_surface, run, gather_surface, close_contest, nullptr \
    }

// Its grid interpolation chooses its own parameters and cannot take part.
extern "C" const bench_entry bench_occt[] = {
    CURVE("Geom_BSplineCurve", CURVE_POINTS, run_curve),
    CURVE("GeomAdaptor_Curve", CURVE_POINTS, run_curve_adaptor),
    CURVE("Geom_BSplineCurve", CURVE_SINGLE, run_curve),
    CURVE("GeomAdaptor_Curve", CURVE_SINGLE, run_curve_adaptor),
    SURFACE("Geom_BSplineSurface", SURFACE_GRID, run_surface),
    SURFACE("GeomAdaptor_Surface", SURFACE_GRID, run_surface_adaptor),
    SURFACE("Geom_BSplineSurface", SURFACE_POINTS, run_surface),
    SURFACE("GeomAdaptor_Surface", SURFACE_POINTS, run_surface_adaptor),
    SURFACE("Geom_BSplineSurface", SURFACE_SINGLE, run_surface),
    SURFACE("GeomAdaptor_Surface", SURFACE_SINGLE, run_surface_adaptor),
    {"GeomAPI_Interpolate", CURVE_THROUGH, open_data, run_curve_through, gather_curve_through,
     close_contest, nullptr},
    {"GCPnts_AbscissaPoint", CURVE_LENGTH, open_curve, run_length, gather_length, close_contest,
     nullptr},
    {},
};
