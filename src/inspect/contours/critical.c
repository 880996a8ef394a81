/* Points where a field stands still, by Newton's method on its gradient. */
#include "base/list.h"
#include "inspect/contours/net.h"
#include "numeric/vector.h"

#include <float.h>
#include <string.h>

enum { MOST_CRITICALS = 4096, MOST_STEPS = 20 };

typedef struct {
    double low[2], high[2]; /* the box of a triangle's corners in u, v */
    double steps[2];        /* of difference quotients */
} range;

static range range_of(const bat_triangle *t)
{
    range r;
    for (int k = 0; k < 2; k++) {
        r.low[k] = bat_min(t->uv[0][k], bat_min(t->uv[1][k], t->uv[2][k]));
        r.high[k] = bat_max(t->uv[0][k], bat_max(t->uv[1][k], t->uv[2][k]));
        /* The cube root of eps balances truncation and rounding of a central difference. */
        r.steps[k] = 6e-6 * (r.high[k] - r.low[k]);
    }
    return r;
}

/* The barycentric coordinates of uv in a triangle. */
static bool weights_of(const bat_triangle *t, const double uv[2], double w[3])
{
    const double a = t->uv[1][0] - t->uv[0][0], b = t->uv[2][0] - t->uv[0][0];
    const double c = t->uv[1][1] - t->uv[0][1], d = t->uv[2][1] - t->uv[0][1];
    const double x = uv[0] - t->uv[0][0], y = uv[1] - t->uv[0][1], det = a * d - b * c;
    if (!(fabs(det) > 0))
        return false;
    w[1] = (x * d - b * y) / det;
    w[2] = (a * y - x * c) / det;
    w[0] = 1 - w[1] - w[2];
    return isfinite(w[1]) && isfinite(w[2]);
}

static double least_weight(const double w[3])
{
    return bat_min(w[0], bat_min(w[1], w[2]));
}

/* The point of a triangle's plane with these weights, drawn into the triangle. */
static void point_of(const bat_triangle *t, const double w[3], double uv[2])
{
    double inside[3], sum = 0;
    for (int k = 0; k < 3; k++)
        sum += inside[k] = bat_max(w[k], 0.01);
    for (int i = 0; i < 2; i++)
        uv[i] =
            (inside[0] * t->uv[0][i] + inside[1] * t->uv[1][i] + inside[2] * t->uv[2][i]) / sum;
}

/* Where the gradients at the corners, taken as linear between, vanish: inside the triangle or
 * not far from it? */
static bool is_candidate(const bat_triangle *t, double gradients[3][2], double uv[2])
{
    bat_triangle image = *t;
    memcpy(image.uv, gradients, sizeof image.uv);
    double w[3];
    if (!weights_of(&image, (const double[2]){0, 0}, w) || least_weight(w) < -0.5)
        return false;
    point_of(t, w, uv);
    return true;
}

/* Second derivatives: Fuu, Fuv, Fvv, from differences that stay near the triangle. */
static batten_status hessian_at(const bat_net *net, const bat_triangle *t, const range *r,
                                const double uv[2], double hessian[3])
{
    double slopes[2][2][2], value;
    for (int k = 0; k < 2; k++)
        for (int side = 0; side < 2; side++) {
            double at[2] = {uv[0], uv[1]};
            at[k] += side ? r->steps[k] : -r->steps[k];
            const batten_status status =
                bat_net_field(net, t->piece, at, &value, slopes[k][side], NULL);
            if (status != BATTEN_OK)
                return status;
        }
    hessian[0] = (slopes[0][1][0] - slopes[0][0][0]) / (2 * r->steps[0]);
    hessian[1] = 0.5 * ((slopes[0][1][1] - slopes[0][0][1]) / (2 * r->steps[0]) +
                        (slopes[1][1][0] - slopes[1][0][0]) / (2 * r->steps[1]));
    hessian[2] = (slopes[1][1][1] - slopes[1][0][1]) / (2 * r->steps[1]);
    return BATTEN_OK;
}

/* The Hessian in units of the triangle's sides; false where it is singular: the field is
 * constant along a line, as on a ridge, and its point no isolated one. */
static bool is_regular(const range *r, const double hessian[3], double *determinant)
{
    const double a = r->high[0] - r->low[0], b = r->high[1] - r->low[1];
    const double uu = hessian[0] * a * a, uv = hessian[1] * a * b, vv = hessian[2] * b * b;
    const double largest = bat_max(fabs(uu), bat_max(fabs(uv), fabs(vv)));
    *determinant = uu * vv - uv * uv;
    /* Difference quotients keep ten digits of the Hessian: six of them must say it is regular.
     */
    return fabs(*determinant) > 1e-6 * largest * largest;
}

typedef struct {
    bool found;
    double uv[2], value, hessian[3];
} search;

/* The corners of a piece bound where it may be evaluated. */
static bool is_inside(const bat_net *net, const bat_triangle *t, const range *r,
                      const double uv[2])
{
    const bat_pieces *p = net->pieces;
    const int count = p->corner_count;
    const double *corners = p->uv + 2 * (size_t)t->piece * (size_t)count;
    for (int k = 0; k < count; k++) {
        const double *a = corners + 2 * k, *b = corners + 2 * ((k + 1) % count);
        const double x = b[0] - a[0], y = b[1] - a[1];
        const double off = x * (uv[1] - a[1]) - y * (uv[0] - a[0]);
        if (!(off > fabs(x) * r->steps[1] + fabs(y) * r->steps[0]))
            return false;
    }
    return true;
}

static batten_status newton(const bat_net *net, const bat_triangle *t, search *s)
{
    const range r = range_of(t);
    const double wide = r.high[0] - r.low[0], high = r.high[1] - r.low[1];
    for (int step = 0; step < MOST_STEPS; step++) {
        double gradient[2], determinant;
        if (!is_inside(net, t, &r, s->uv))
            return BATTEN_OK;
        batten_status status = bat_net_field(net, t->piece, s->uv, &s->value, gradient, NULL);
        if (status == BATTEN_OK)
            status = hessian_at(net, t, &r, s->uv, s->hessian);
        if (status != BATTEN_OK || !is_regular(&r, s->hessian, &determinant))
            return status;
        const double *h = s->hessian, det = h[0] * h[2] - h[1] * h[1];
        const double du = -(h[2] * gradient[0] - h[1] * gradient[1]) / det;
        const double dv = -(h[0] * gradient[1] - h[1] * gradient[0]) / det;
        if (!(fabs(du) <= wide && fabs(dv) <= high))
            return BATTEN_OK;
        s->uv[0] += du;
        s->uv[1] += dv;
        /* Steps of Newton square: after 1e-9 of the triangle nothing is left to gain. */
        if (fabs(du) <= 1e-9 * wide && fabs(dv) <= 1e-9 * high) {
            s->found = is_inside(net, t, &r, s->uv);
            return BATTEN_OK;
        }
    }
    return BATTEN_OK;
}

/* ---- keeping ---- */

static bool is_known(const bat_net *net, const double *point)
{
    for (int i = 0; i < net->critical_count; i++) {
        const batten_vec3 known = net->criticals[i].point;
        /* Found from two triangles, a point differs by what Newton leaves: less than 1e-8. */
        if (bat_distance(3, (const double[3]){known.x, known.y, known.z}, point) <=
            1e-7 * net->pieces->size)
            return true;
    }
    return false;
}

static batten_status keep_critical(bat_net *net, const search *s, const double *point)
{
    if (BAT_LIST_GROW(net->criticals, net->critical_count, net->critical_capacity, 1) !=
        BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    const double *h = s->hessian;
    const batten_critical_kind kind = h[0] * h[2] - h[1] * h[1] < 0 ? BATTEN_CRITICAL_SADDLE
                                      : h[0] + h[2] > 0             ? BATTEN_CRITICAL_LEAST
                                                                    : BATTEN_CRITICAL_GREATEST;
    net->criticals[net->critical_count++] =
        (batten_critical){kind, s->value, s->uv[0], s->uv[1], bat_vec3_of(3, point)};
    return BATTEN_OK;
}

/* A triangle becomes three around a new node; one that is a corner already is only marked. */
static batten_status insert_critical(bat_net *net, size_t index, const search *s,
                                     const double w[3])
{
    const bat_triangle t = net->triangles[index];
    for (int k = 0; k < 3; k++)
        /* Nearer to a corner a triangle would be a sliver of no area. */
        if (w[k] > 1 - 1e-7) {
            net->critical[t.node[k]] = true;
            net->values[t.node[k]] = s->value;
            return BATTEN_OK;
        }
    int node;
    batten_status status = bat_net_add_node(net, s->value, &node);
    for (int k = 0; k < 3 && status == BATTEN_OK; k++) {
        bat_triangle part = t;
        part.node[k] = node;
        memcpy(part.uv[k], s->uv, sizeof part.uv[k]);
        if (k == 0)
            net->triangles[index] = part;
        else
            status = bat_net_add_triangle(net, &part);
    }
    if (status == BATTEN_OK)
        net->critical[node] = true;
    return status;
}

/* Newton may leave the triangle that it began in. */
static batten_status insert_where_it_lies(bat_net *net, int piece, size_t begin,
                                          const search *s)
{
    const size_t count = net->triangle_count;
    for (size_t k = 0; k < count; k++) {
        const size_t i = (begin + k) % count;
        /* Within rounding of an edge either triangle will do. */
        double w[3];
        if (net->triangles[i].piece == piece && weights_of(&net->triangles[i], s->uv, w) &&
            least_weight(w) >= -1e-9)
            return insert_critical(net, i, s, w);
    }
    return BATTEN_OK;
}

static batten_status look_in_triangle(bat_net *net, size_t index)
{
    const bat_triangle t = net->triangles[index];
    double gradients[3][2], value;
    for (int k = 0; k < 3; k++) {
        const batten_status status =
            bat_net_field(net, t.piece, t.uv[k], &value, gradients[k], NULL);
        if (status != BATTEN_OK)
            return status;
    }
    search s = {.found = false};
    if (!is_candidate(&t, gradients, s.uv))
        return BATTEN_OK;
    batten_status status = newton(net, &t, &s);
    double derivatives[9];
    if (status == BATTEN_OK && s.found)
        status = bat_net_field(net, t.piece, s.uv, &s.value, NULL, derivatives);
    if (status != BATTEN_OK || !s.found || is_known(net, derivatives) ||
        net->critical_count >= MOST_CRITICALS)
        return status;
    status = keep_critical(net, &s, derivatives);
    return status == BATTEN_OK ? insert_where_it_lies(net, t.piece, index, &s) : status;
}

batten_status bat_net_find_criticals(bat_net *net)
{
    const size_t count = net->triangle_count;
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < count && status == BATTEN_OK; i++) {
        status = look_in_triangle(net, i);
        if (status == BATTEN_OK && i % 1024 == 0)
            status = bat_work_step(&net->work, 1024, (double)i / (double)count, "contours");
    }
    return status;
}
