/* The joins of a check in its report: each of them, how smooth they are, and the worst of all. */
#include "base/plural.h"
#include "design/outputs/report_parts.h"

enum { GAP, ANGLE, CURVATURE, RATE, MEASURES };

/* A smaller part of the tolerance is rounding, and 0 in the text; JSON has its digits. */
static const double NO_GAP = 1e-8;

static void add_gap(batten_text *out, const bat_check *check, double gap)
{
    bat_report_length(out, check, gap < NO_GAP * bat_tolerance(check->run) ? 0 : gap);
}

static const batten_join_worst *measure_of(const bat_join *join, int which)
{
    const batten_join_worst *const all[MEASURES] = {&join->of.gap, &join->of.angle,
                                                    &join->of.curvature, &join->of.rate};
    return all[which];
}

static batten_object_kind kind_of(const bat_check *check, const bat_join *join)
{
    return check->objects[join->of.shape[0]].object->kind;
}

/* ---- the worst of all ---- */

/* Over the joins of one kind of object. */
typedef struct {
    int count, of_order[5]; /* gaps, G0 .. G3 */
    const bat_join *worst[MEASURES];
} summary;

/* A jump of some order is counted where all below it are smooth: a crease has no common curvature. */
static summary sum_up(const bat_check *check, batten_object_kind kind)
{
    summary s = {0};
    for (int i = 0; i < check->join_count; i++) {
        const bat_join *join = &check->joins[i];
        if (kind_of(check, join) != kind)
            continue;
        s.count++;
        s.of_order[join->of.geometric + 1]++;
        for (int k = 0; k < MEASURES; k++)
            if (k <= join->of.geometric + 1 && isfinite(measure_of(join, k)->value) &&
                (!s.worst[k] || measure_of(join, k)->value > measure_of(s.worst[k], k)->value))
                s.worst[k] = join;
    }
    return s;
}

static void add_place(batten_text *out, batten_vec3 at)
{
    const double p[3] = {at.x, at.y, at.z};
    for (int k = 0; k < 3; k++) {
        batten_text_add(out, k ? ", " : "(");
        bat_report_rounded(out, p[k]);
    }
    batten_text_add(out, ")");
}

static void add_names(batten_text *out, const bat_check *check, const bat_join *join)
{
    for (int k = 0; k < 2; k++) {
        const batten_object *object = check->objects[join->of.shape[k]].object;
        if (object->kind == BATTEN_OBJECT_BODY && k == 0)
            batten_text_add(out, "%s, edge %d of faces %d", object->name, join->of.edge + 1,
                            join->face[0] + 1);
        else if (object->kind == BATTEN_OBJECT_BODY)
            batten_text_add(out, " and %d", join->face[1] + 1);
        else
            batten_text_add(out, "%s%s%s, %s", k ? " and " : "",
                            join->of.part == 1 - k ? "a part of " : "", object->name,
                            bat_side_name(object, join->of.side[k]));
    }
}

static void text_worst(batten_text *out, const bat_check *check, const bat_join *join,
                       int which)
{
    static const char *const before[MEASURES] = {
        "widest gap ", "largest turn ",
        "where they turn less than the bound, curvatures differ by up to ",
        "where curvatures agree, too, their rates differ by up to "};
    const batten_join_worst *worst = measure_of(join, which);
    batten_text_add(out, "    %s", before[which]);
    if (which == GAP)
        add_gap(out, check, worst->value);
    else
        bat_report_rounded(out, worst->value);
    batten_text_add(out, "%s at ",
                    which == ANGLE       ? " rad"
                    : which == CURVATURE ? " of the larger"
                    : which == RATE      ? " of the larger"
                                         : "");
    add_place(out, worst->at);
    batten_text_add(out, ": ");
    add_names(out, check, join);
    batten_text_add(out, "\n");
}

static void text_summary(const bat_check *check, batten_object_kind kind, const char *noun,
                         batten_text *out)
{
    static const char *const orders[] = {"apart", "G0", "G1", "G2", "G3"};
    const summary s = sum_up(check, kind);
    const char *separator = ": ";
    if (s.count < 2)
        return;
    batten_text_add(out, "  %d common %s%s", s.count, noun, bat_plural(s.count));
    for (int k = 0; k < 5; k++)
        if (s.of_order[k]) {
            batten_text_add(out, "%s%d %s", separator, s.of_order[k], orders[k]);
            separator = ", ";
        }
    batten_text_add(out, "\n");
    for (int k = 0; k < MEASURES; k++)
        if (s.worst[k])
            text_worst(out, check, s.worst[k], k);
}

/* ---- each of them ---- */

/* Where that is which keeps an edge from being smoother. */
static void add_failing_place(batten_text *out, const bat_join *join)
{
    static const char *const what[] = {"", "turning", "curvatures differing",
                                       "rates differing"};
    const int next = join->of.geometric + 1;
    if (next < ANGLE || next > RATE || !isfinite(measure_of(join, next)->value))
        return;
    batten_text_add(out, ", %s most at ", what[next]);
    add_place(out, measure_of(join, next)->at);
}

static void text_join(batten_text *out, const bat_check *check, const bat_join *join)
{
    const batten_join *of = &join->of;
    const bool is_of_curves = kind_of(check, join) == BATTEN_OBJECT_CURVE;
    batten_text_add(out, "  ");
    add_names(out, check, join);
    batten_text_add(out, ": gap ");
    add_gap(out, check, of->gap.value);
    if (isfinite(of->angle.value)) {
        batten_text_add(out, ", turning by ");
        bat_report_rounded(out, of->angle.value);
        batten_text_add(out, " rad, ");
        if (isfinite(of->curvature.value)) {
            batten_text_add(out, "curvatures differ by ");
            bat_report_rounded(out, of->curvature.value);
            batten_text_add(out, " of the larger");
        } else {
            batten_text_add(out, "curvatures not known at a %s",
                            is_of_curves ? "cusp" : "pole");
        }
    }
    if (is_of_curves && of->parametric >= 0)
        batten_text_add(out, ": C%d, G%d", of->parametric, of->geometric);
    else if (!is_of_curves) {
        batten_text_add(out, ": G%d", of->geometric);
        add_failing_place(out, join);
    }
    batten_text_add(out, "%s\n",
                    join->is_knuckle  ? ": a declared knuckle"
                    : join->is_branch ? ": not judged, other ends meet there"
                                      : "");
}

void bat_joins_text(const bat_check *check, batten_text *out)
{
    if (check->join_count)
        batten_text_add(out, "\nWhat meets\n");
    for (int i = 0; i < check->join_count; i++)
        if (kind_of(check, &check->joins[i]) != BATTEN_OBJECT_BODY)
            text_join(out, check, &check->joins[i]);
    text_summary(check, BATTEN_OBJECT_SURFACE, "edge", out);
    text_summary(check, BATTEN_OBJECT_BODY, "edge of faces", out);
}

/* ---- JSON ---- */

static void json_sides(batten_text *out, const bat_check *check, const bat_join *join)
{
    for (int k = 0; k < 2; k++) {
        const batten_object *object = check->objects[join->of.shape[k]].object;
        batten_text_add(out, k ? ", \"b\": " : "{\"a\": ");
        batten_text_json(out, object->name);
        if (object->kind == BATTEN_OBJECT_BODY)
            batten_text_add(out, ", \"face_%c\": %d", k ? 'b' : 'a', join->face[k] + 1);
        else
            batten_text_add(out, ", \"side_%c\": \"%s\"", k ? 'b' : 'a',
                            bat_side_name(object, join->of.side[k]));
    }
    if (join->of.edge >= 0)
        batten_text_add(out, ", \"edge\": %d", join->of.edge + 1);
}

/* Rates as they are; the part of the larger one that they differ by is among the places. */
static void json_measures(batten_text *out, const bat_join *join)
{
    static const char *const keys[] = {"g0", "g1", "g2", "g3"};
    const batten_join *of = &join->of;
    const double values[] = {of->gap.value, of->angle.value, of->curvature.value,
                             of->rate_difference};
    for (int k = 0; k < MEASURES; k++) {
        batten_text_add(out, ", ");
        bat_report_number(out, keys[k], values[k]);
    }
}

static void json_places(batten_text *out, const bat_join *join)
{
    static const char *const keys[] = {"g0_at", "g1_at", "g2_at", "g3_at"};
    batten_text_add(out, ", ");
    bat_report_number(out, "curvature_jump", join->of.curvature_difference);
    batten_text_add(out, ", ");
    bat_report_number(out, "rate_part", join->of.rate.value);
    for (int k = 0; k < MEASURES; k++) {
        const batten_join_worst *worst = measure_of(join, k);
        const double p[3] = {worst->at.x, worst->at.y, worst->at.z};
        if (isfinite(worst->value)) {
            batten_text_add(out, ", ");
            bat_report_point(out, keys[k], p);
        }
    }
}

void bat_joins_json(const bat_check *check, batten_text *out)
{
    for (int i = 0; i < check->join_count; i++) {
        const bat_join *join = &check->joins[i];
        const double p[3] = {join->of.gap.at.x, join->of.gap.at.y, join->of.gap.at.z};
        const bool is_of_curves = kind_of(check, join) == BATTEN_OBJECT_CURVE;
        batten_text_add(out, "%s\n    ", i ? "," : "");
        json_sides(out, check, join);
        json_measures(out, join);
        if (join->of.part >= 0)
            batten_text_add(out, ", \"part\": \"%c\"", join->of.part ? 'b' : 'a');
        if (is_of_curves)
            batten_text_add(out, ", \"c\": %d", join->of.parametric);
        batten_text_add(out, ", \"g\": %d%s", join->of.geometric,
                        join->is_knuckle  ? ", \"knuckle\": true"
                        : join->is_branch ? ", \"branch\": true"
                                          : "");
        if (is_of_curves) {
            batten_text_add(out, ", ");
            bat_report_point(out, "at", p);
        } else {
            json_places(out, join);
        }
        batten_text_add(out, "}");
    }
}

void bat_worst_joins_json(const bat_check *check, batten_text *out)
{
    static const char *const names[MEASURES] = {"gap", "angle", "curvature", "rate"};
    const char *separator = "";
    for (int kind = 0; kind < 2; kind++) {
        const summary s = sum_up(check, kind ? BATTEN_OBJECT_BODY : BATTEN_OBJECT_SURFACE);
        for (int k = 0; k < MEASURES; k++) {
            if (!s.worst[k])
                continue;
            const batten_join_worst *worst = measure_of(s.worst[k], k);
            const double p[3] = {worst->at.x, worst->at.y, worst->at.z};
            batten_text_add(out, "%s\n    {\"worst\": \"%s\", \"join\": %d, ", separator,
                            names[k], (int)(s.worst[k] - check->joins) + 1);
            bat_report_number(out, "value", worst->value);
            batten_text_add(out, ", ");
            bat_report_point(out, "at", p);
            batten_text_add(out, "}");
            separator = ",";
        }
    }
}
