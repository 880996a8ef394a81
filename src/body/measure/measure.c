/* Area, volume, centroid and edge length of bodies, by integrals along the loops of faces. */
#include "base/work.h"
#include "body/measure/box.h"
#include "body/measure/extent.h"
#include "body/measure/face_integral.h"
#include "body/trace/all.h"
#include "body/trace/passages.h"
#include "numeric/box.h"
#include "numeric/vector.h"
#include <batten/measure.h>

#include <string.h>

/* So often a surface may be asked for the integrals of one face. */
static const size_t MOST = 1u << 22;

/* Edges that miss their faces by more than this share of the size of the body bound nothing. */
static const double COARSEST = 1e-3;

typedef struct {
    const batten_body_parts *given;
    const bat_traced_all *traced;
    bat_face_rules rules;
    bat_face_sums sums; /* over all faces */
    double gross;       /* the sum of the sizes of the areas of faces */
    int unmet;
    int first_unmet;
    int crossed; /* faces whose loops cross so much that their area says nothing */
    int first_crossed;
} total;

/* Loops that cross bound no area: what they cut off may count twice, or against the rest. Where
 * that is more than a hair of the face, all of it is in doubt. */
static batten_status add_doubt(total *t, const batten_body_parts *parts, int f, int number,
                               bat_face_sums *face)
{
    const double area = fabs(face->values[BAT_AREA]), hair = 1e-3;
    double doubt = 0;
    const batten_status status = bat_loops_doubt(parts, f, &doubt);
    doubt /= t->rules.size * t->rules.size;
    if (doubt > hair * area) {
        doubt = bat_max(doubt, area);
        if (t->crossed++ == 0)
            t->first_crossed = number;
    }
    face->slack += doubt;
    return status;
}

static void add_face(total *t, int number, const bat_face_sums *face)
{
    bat_face_add(&t->sums, face);
    t->gross += fabs(face->values[BAT_AREA]);
    if (!face->is_met && t->unmet++ == 0)
        t->first_unmet = number;
}

static batten_status add_faces(total *t, const batten_job *job)
{
    bat_work work = {.job = job};
    int done = 0;
    t->sums = (bat_face_sums){.is_met = true};
    t->gross = 0;
    t->unmet = t->crossed = 0;
    for (int i = 0; i < t->traced->count; i++) {
        const bat_traced *part = &t->traced->at[i];
        const batten_body_parts *parts = batten_body_view(part->body);
        for (int f = 0; f < parts->face_count; f++) {
            bat_face_sums face;
            batten_status status = bat_face_integrate(parts, f, &t->rules, &face);
            if (status == BATTEN_OK)
                status = add_doubt(t, parts, f, bat_traced_number(part, f), &face);
            if (status == BATTEN_OK)
                status =
                    bat_work_step(&work, 1, bat_min(1, (double)done++ / t->given->face_count),
                                  "measuring faces");
            if (status != BATTEN_OK)
                return status;
            add_face(t, bat_traced_number(part, f), &face);
        }
    }
    return BATTEN_OK;
}

/* Has every edge with a curve as many uses one way as the other, one each? Of a traced part
 * only faces count that had no loops before. */
static batten_status find_balanced(const batten_body_parts *parts, const total *t,
                                   const bat_traced *part, bool *balanced)
{
    char *ways = bat_array((size_t)parts->edge_count + 1, 1);
    if (!ways)
        return BATTEN_OUT_OF_MEMORY;
    memset(ways, 0, (size_t)parts->edge_count + 1);
    for (int f = 0; f < parts->face_count; f++) {
        const batten_body_face *face = &parts->faces[f];
        if (part && t->given->faces[bat_traced_number(part, f)].count > 0)
            continue;
        for (int l = face->first; l < face->first + face->count; l++)
            for (int i = 0; i < parts->loops[l].count; i++) {
                const batten_body_use *use = &parts->uses[parts->loops[l].first + i];
                const char way = use->reversed ? 2 : 1;
                *balanced =
                    *balanced && !(parts->edges[use->edge].curve && (ways[use->edge] & way));
                ways[use->edge] = (char)(ways[use->edge] | way);
            }
    }
    for (int i = 0; i < parts->edge_count; i++)
        *balanced = *balanced && (!parts->edges[i].curve || ways[i] == 3 || ways[i] == 0);
    bat_release(ways);
    return BATTEN_OK;
}

static batten_status find_closed(const total *t, bool *closed)
{
    *closed = t->given->face_count > 0 && t->traced->failed == 0;
    batten_status status = find_balanced(t->given, t, NULL, closed);
    for (int i = 0; i < t->traced->count && status == BATTEN_OK; i++) {
        const bat_traced *part = &t->traced->at[i];
        status = find_balanced(batten_body_view(part->body), t, part, closed);
    }
    return status;
}

static batten_status add_lengths(const batten_body_parts *parts, double precision,
                                 double *length)
{
    for (int i = 0; i < parts->edge_count; i++) {
        const batten_curve *curve = parts->edges[i].curve;
        double one = 0;
        if (!curve)
            continue;
        const batten_box box = batten_curve_box(curve);
        const double size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
        if (size == 0)
            continue;
        batten_status status = batten_curve_length(curve, precision * size, NULL, &one);
        if (status != BATTEN_OK && status != BATTEN_TOLERANCE_NOT_MET)
            return status;
        *length += one;
    }
    return BATTEN_OK;
}

static void set_centroid(const total *t, batten_body_measures *out)
{
    const double *values = t->sums.values;
    const double of = out->is_closed ? bat_face_volume(&t->sums) : values[BAT_AREA];
    const double *moment = values + (out->is_closed ? BAT_VOLUME_MOMENT : BAT_AREA_MOMENT);
    const double centre[3] = {t->rules.centre.x, t->rules.centre.y, t->rules.centre.z};
    for (int k = 0; k < 3; k++)
        out->centroid[k] = centre[k] + (of != 0 ? moment[k] / of * t->rules.size : 0);
}

static batten_status integrate(total *t, double precision, const batten_job *job,
                               batten_body_measures *out)
{
    const double size = t->rules.size;
    batten_status status = find_closed(t, &out->is_closed);
    out->is_closed = out->is_closed && t->traced->rims == 0;
    t->rules.area_precision = t->rules.volume_precision = precision;
    if (status == BATTEN_OK)
        status = add_faces(t, job);
    /* A thin or a small volume in a large box asks for more. */
    const double volume = status == BATTEN_OK ? fabs(bat_face_volume(&t->sums)) : 0;
    if (status == BATTEN_OK && out->is_closed && volume > 0 &&
        t->sums.volume_error > precision * volume) {
        t->rules.volume_precision = precision * volume / t->gross;
        status = add_faces(t, job);
    }
    if (status != BATTEN_OK)
        return status;
    out->area = t->sums.values[BAT_AREA] * size * size;
    out->area_error = (t->sums.area_error + t->sums.slack) * size * size;
    if (out->is_closed) {
        out->volume = bat_face_volume(&t->sums) * size * size * size;
        out->volume_error = bat_face_volume_error(&t->sums) * size * size * size;
    }
    set_centroid(t, out);
    return BATTEN_OK;
}

/* The first face that could not be traced. */
static int first_failed(const bat_traced_all *traced)
{
    int f = 0;
    while (!traced->is_failed[f])
        f++;
    return f;
}

static batten_status finish_measures(const total *t, double precision,
                                     const batten_body_measures *out)
{
    const double volume = fabs(bat_face_volume(&t->sums));
    if (!isfinite(out->area) || !isfinite(out->volume))
        return bat_fail(BATTEN_OVERFLOW, "the area is %g and the volume %g", out->area,
                        out->volume);
    if (t->traced->failed > 0)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "%d of %d faces have no closed loops in their parameters and are not "
                        "measured, face %d first",
                        t->traced->failed, t->given->face_count, first_failed(t->traced) + 1);
    if (t->crossed > 0)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "%d of %d faces have loops that cross, face %d first: the area is %g, "
                        "within %g",
                        t->crossed, t->given->face_count, t->first_crossed + 1, out->area,
                        out->area_error);
    if (t->unmet > 0)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "%d of %d faces do not reach the precision %g, face %d first: the area "
                        "is %g, within %g",
                        t->unmet, t->given->face_count, precision, t->first_unmet + 1,
                        out->area, out->area_error);
    /* Below some 1e-13 both sides are rounding. */
    if (out->is_closed && t->sums.volume_error > bat_max(precision * volume, 1e-13 * t->gross))
        return bat_fail(BATTEN_TOLERANCE_NOT_MET, "the volume is %g, within %g", out->volume,
                        out->volume_error);
    return BATTEN_OK;
}

/* The tight box; where faces could not be traced that of their surfaces. */
static batten_status find_box(const batten_body *body, const total *t, double precision,
                              batten_body_measures *out)
{
    bat_extent extent = {bat_box_of_nothing(), bat_box_of_nothing()};
    batten_status status = bat_edges_extent(t->given, &extent);
    for (int i = 0; status == BATTEN_OK && i < t->traced->count; i++) {
        const batten_body_parts *parts = batten_body_view(t->traced->at[i].body);
        status = bat_edges_extent(parts, &extent);
        for (int f = 0; status == BATTEN_OK && f < parts->face_count; f++)
            status = bat_face_extent(parts, f, precision * t->rules.size, &extent);
    }
    if (status == BATTEN_OK && t->traced->failed > 0) {
        status = bat_body_find_box(body, &extent.within);
        bat_box_join(&extent.within, extent.reached);
    }
    if (status != BATTEN_OK || bat_box_is_of_nothing(extent.within))
        return status;
    out->box = extent.within;
    out->box_error = bat_extent_slack(&extent);
    return BATTEN_OK;
}

batten_status batten_body_measure(const batten_body *body, double precision,
                                  const batten_job *job, batten_body_measures *out)
{
    assert(body && out);
    bat_traced_all traced;
    batten_body_measures made = {.area = 0};
    if (!(precision > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the precision is %g; it must be positive",
                        precision);
    total t = {.given = batten_body_view(body), .traced = &traced};
    t.rules = bat_face_rules_of(body);
    t.rules.most = MOST;
    batten_status status = bat_trace_all(body, COARSEST * t.rules.size, job, &traced);
    if (status != BATTEN_OK)
        return status;
    made.unmeasured = traced.failed;
    status = add_lengths(t.given, precision, &made.edge_length);
    if (status == BATTEN_OK)
        status = integrate(&t, precision, job, &made);
    if (status == BATTEN_OK)
        status = find_box(body, &t, precision, &made);
    if (status == BATTEN_OK)
        status = finish_measures(&t, precision, &made);
    if (status == BATTEN_OK || status == BATTEN_TOLERANCE_NOT_MET)
        *out = made;
    bat_trace_all_end(&traced);
    return status;
}
