/* The points of a lofting: their rows, their feet on the patch, and how far it moved from them. */
#include "loft/data.h"
#include "numeric/vector.h"

/* The share of the bound that programs use: the rest is for what a round changes of normals and
 * feet, which the next one sees. */
static const double share_of_bound = 0.995;

/* How far a datum's foot may slide within the surface from round to round, and how much a slide
 * counts against a move, in bounds. */
static const double most_slide = 20, slide_weight = 30;

/* The normal and two directions along the surface; the first along the edge of a rim. */
typedef struct {
    double n[3], along[3], across[3];
} frame;

static void frame_at(const bat_loft_datum *d, const bat_loft_place *place, frame *out)
{
    const double *edge = d->on_u_edge && !d->on_v_edge ? place->s[0][1] : place->s[1][0];
    if (!(bat_loft_normal(place, out->n) > 0)) {
        out->n[0] = out->n[2] = 0;
        out->n[1] = 1;
    }
    const double length = bat_norm(3, edge);
    for (int c = 0; c < 3; c++)
        out->along[c] = length > 0 ? edge[c] / length : c == 0;
    bat_loft_cross(out->n, out->along, out->across);
}

/* |direction . (S + move - point)| <= within, and the square of it over `scale`. */
static batten_status add_direction(bat_loft_program *p, const bat_loft_place *place,
                                   const bat_loft_datum *d, const double direction[3],
                                   double within, double scale)
{
    bat_loft_measure measure = {.weight[0][0] = 1};
    double missing = 0;
    for (int c = 0; c < 3; c++) {
        measure.vector[c] = direction[c];
        missing += direction[c] * (d->point[c] - place->s[0][0][c]);
    }
    bat_loft_add_square(p, place, &measure, 2 / (scale * scale), missing);
    batten_status status = bat_loft_add_row(p, place, &measure, within + missing, HUGE_VAL);
    for (int c = 0; c < 3; c++)
        measure.vector[c] = -direction[c];
    if (status == BATTEN_OK)
        status = bat_loft_add_row(p, place, &measure, within - missing, HUGE_VAL);
    return status;
}

/* Of the ball of a fixed place, the box with this share of the bound along the normal and the
 * other across it: their squares are 0.993. */
static const double share_along_normal = 0.8, share_across = 0.42;

/* The place stays in a box within the ball of the point. */
static batten_status add_fixed(bat_loft_program *p, const bat_loft_place *place,
                               const bat_loft_datum *d, const frame *f)
{
    const double w = share_of_bound * share_along_normal * d->within,
                 slide = share_of_bound * share_across * d->within;
    batten_status status = add_direction(p, place, d, f->n, w, w);
    if (status == BATTEN_OK)
        status = add_direction(p, place, d, f->along, slide, slide);
    return status == BATTEN_OK ? add_direction(p, place, d, f->across, slide, slide) : status;
}

batten_status bat_loft_add_datum(bat_loft_program *p, const bat_loft_datum *d)
{
    bat_loft_place place;
    frame f;
    bat_loft_place_at(p->patch, d->u, d->v, &place);
    frame_at(d, &place, &f);
    if (d->is_fixed)
        return add_fixed(p, &place, d, &f);
    const bool rim = d->on_u_edge || d->on_v_edge, corner = d->on_u_edge && d->on_v_edge;
    /* The bound is shared by the directions in which the patch cannot slide past the point. */
    const double share = corner ? sqrt(1. / 3) : rim ? sqrt(0.5) : 1;
    const double normal = d->in_station ? bat_max(bat_hypot(f.n[1], f.n[2]), 0.05)
                                        : 1; /* 5 % of it near the ends */
    const double w = share_of_bound * share * normal * d->within;
    batten_status status = add_direction(p, &place, d, f.n, w, w);
    if (status != BATTEN_OK)
        return status;
    const double along = corner ? w : most_slide * d->within;
    const double across = rim ? w : most_slide * d->within;
    status = add_direction(p, &place, d, f.along, along, corner ? w : slide_weight * d->within);
    if (status == BATTEN_OK)
        status =
            add_direction(p, &place, d, f.across, across, rim ? w : slide_weight * d->within);
    return status;
}

void bat_loft_attract_datum(bat_loft_program *program, const bat_loft_datum *datum)
{
    bat_loft_place place;
    bat_loft_place_at(program->patch, datum->u, datum->v, &place);
    for (int c = 0; c < 3; c++) {
        bat_loft_measure measure = {.weight[0][0] = 1};
        measure.vector[c] = 1;
        bat_loft_add_square(program, &place, &measure, 2 / (datum->within * datum->within),
                            datum->point[c] - place.s[0][0][c]);
    }
}

/* One step towards the foot: in the plane of the station where the datum lies in one, along
 * its edge where it belongs to one. */
static void step_to_foot(const bat_loft_place *place, const bat_loft_datum *d, double step[2])
{
    const double *su = place->s[1][0], *sv = place->s[0][1];
    double e = 0, f = 0, g = 0, x = 0, y = 0;
    for (int c = 0; c < 3; c++) {
        /* Ten thousand times as near in x: then the foot lies in the plane of the station. */
        const double weight = d->in_station && !d->on_u_edge && c == 0 ? 1e8 : 1;
        const double offset = d->point[c] - place->s[0][0][c];
        e += weight * su[c] * su[c];
        f += weight * su[c] * sv[c];
        g += weight * sv[c] * sv[c];
        x += weight * offset * su[c];
        y += weight * offset * sv[c];
    }
    const double det = e * g - f * f;
    const bool u = !d->on_u_edge, v = !d->on_v_edge;
    step[0] = u && v ? (x * g - y * f) / det : u ? x / e : 0;
    step[1] = u && v ? (y * e - x * f) / det : v ? y / g : 0;
}

static double clip_step(double at, double step)
{
    const double longest = 0.05;
    return bat_min(bat_max(at + bat_min(bat_max(step, -longest), longest), 0), 1);
}

/* Where the patch is nearest to a datum, from where it was. */
static void find_foot(const bat_loft_patch *patch, bat_loft_datum *d)
{
    enum { STEPS = 30 };
    bat_loft_place place;
    double step[2];
    bat_loft_place_at(patch, d->u, d->v, &place);
    for (int k = 0; k < STEPS && !d->is_fixed; k++) {
        step_to_foot(&place, d, step);
        if (!isfinite(step[0]) || !isfinite(step[1]))
            break;
        d->u = clip_step(d->u, step[0]);
        d->v = clip_step(d->v, step[1]);
        bat_loft_place_at(patch, d->u, d->v, &place);
    }
    d->move = bat_distance(3, place.s[0][0], d->point);
}

void bat_loft_find_feet(const bat_loft_patch *patch, int count, bat_loft_datum *data,
                        bat_loft_moves *out)
{
    double squares = 0;
    *out = (bat_loft_moves){0};
    for (int k = 0; k < count; k++) {
        bat_loft_datum *d = data + k;
        find_foot(patch, d);
        squares += d->move * d->move;
        out->largest = bat_max(out->largest, d->move);
        out->largest_part = bat_max(out->largest_part, d->move / d->within);
    }
    out->rms = sqrt(squares / bat_max_int(1, count));
}
