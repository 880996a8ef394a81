/* The report of a check as a text for people: four digits, the same in every locale. */
#include "base/plural.h"
#include "design/outputs/corrections.h"
#include "design/outputs/report_parts.h"

#include <string.h>

static void add_plural(batten_text *out, int count, const char *what)
{
    batten_text_add(out, "%d %s%s", count, what, bat_plural(count));
}

/* So many corrections are listed, the farthest; the output 'corrections' has all. */
enum { MOST_CORRECTIONS = 5 };

static void text_loft(batten_text *out, const bat_check *check, const batten_loft_report *l)
{
    batten_text_add(out, "    ");
    add_plural(out, l->correction_count, "point");
    batten_text_add(out, " moved, at most ");
    bat_report_length(out, check, l->max_move);
    batten_text_add(out, ", in the mean ");
    bat_report_length(out, check, l->rms_move);
    batten_text_add(out, "\n");
    for (int k = 0; k < bat_min_int(l->correction_count, MOST_CORRECTIONS); k++) {
        const bat_correction c = bat_loft_correction_at(l, k);
        batten_text_add(out, "      ");
        bat_correction_as_text(&c, bat_check_unit(check), out);
        batten_text_add(out, "\n");
    }
    batten_text_add(out, "    %d of %d sections with inflections in excess, of bulges above ",
                    l->cuts_in_excess, l->cut_count);
    bat_report_length(out, check, l->height);
    batten_text_add(out, "\n");
}

static void text_feature(batten_text *out, const bat_check *check,
                         const batten_feature_result *r)
{
    batten_text_add(out, "  %s (%s)\n", r->name, r->operation);
    if (r->fairing) {
        const batten_fair_report *f = r->fairing;
        batten_text_add(out, "    ");
        add_plural(out, f->moved_count, f->control_points ? "control point" : "point");
        batten_text_add(out, f->control_points ? " moved, the curve by at most "
                                               : " moved, at most ");
        bat_report_length(out, check, f->max_move);
        batten_text_add(out, " (%s %d, %s %d)\n", f->net ? "row" : "curve", f->worst_set + 1,
                        f->control_points ? "control point" : "point", f->worst_index + 1);
        batten_text_add(out, "    inflections in excess: %d before, %d after; energy ",
                        f->before.excess_inflections, f->after.excess_inflections);
        bat_report_rounded(out, f->before.energy);
        batten_text_add(out, " before, ");
        bat_report_rounded(out, f->after.energy);
        batten_text_add(out, " after\n");
        if (f->suspect_count) {
            batten_text_add(out, "    ");
            add_plural(out, f->suspect_count, "point");
            batten_text_add(out, " may be a blunder; see the messages\n");
        }
    }
    if (r->loft)
        text_loft(out, check, r->loft);
    if (r->skin) {
        batten_text_add(out, "    sections moved by at most ");
        bat_report_length(out, check, r->skin->error);
        batten_text_add(out, "; %d inner knot%s along them, the exact union has %d\n",
                        r->skin->knot_count, bat_plural(r->skin->knot_count),
                        r->skin->exact_knot_count);
    } else if (r->has_error && !r->loft) {
        batten_text_add(out, "    error at most ");
        bat_report_length(out, check, r->error_max);
        batten_text_add(out, "\n");
    }
}

/* An energy is stated when four digits of it are known. */
#define KNOWN 5e-5

static void text_fairness(batten_text *out, const batten_fairness *f)
{
    add_plural(out, f->inflections, "inflection");
    batten_text_add(out, ", %d in excess; ", f->excess_inflections);
    batten_text_add(out, "curvature extrema %d, largest curvature ", f->curvature_extrema);
    if (isinf(f->max_curvature))
        batten_text_add(out, "without bound");
    else
        bat_report_rounded(out, f->max_curvature);
    batten_text_add(out, ", energy ");
    if (f->corners) {
        batten_text_add(out, "infinite: ");
        add_plural(out, f->corners, "corner");
    } else if (isinf(f->energy)) {
        batten_text_add(out, "infinite");
    } else if (f->energy_error > KNOWN * f->energy) {
        batten_text_add(out, "not known (infinite, or nearly so)");
    } else {
        bat_report_rounded(out, f->energy);
    }
    if (f->curvature_jumps > 0) {
        batten_text_add(out, ", ");
        add_plural(out, f->curvature_jumps, "jump");
        batten_text_add(out, " of curvature");
    }
}

static void text_distance(batten_text *out, const bat_check *check, const bat_data_distance *d)
{
    const char *when = d->is_faired ? "after fairing," : "given,";
    if (d->count == 0) {
        batten_text_add(out, "    all %d point%s %s '%s', lie beyond the shape\n", d->left_out,
                        bat_plural(d->left_out), when, d->feature);
        return;
    }
    batten_text_add(out, "    distance from the %d point%s %s '%s': at most ", d->count,
                    bat_plural(d->count), when, d->feature);
    bat_report_length(out, check, d->max);
    batten_text_add(out, " (rms ");
    bat_report_rounded(out, d->rms);
    batten_text_add(out, "), at ");
    for (int k = 0; k < 3; k++) {
        bat_report_rounded(out, d->worst[k]);
        batten_text_add(out, k < 2 ? ", " : "");
    }
    if (d->left_out)
        batten_text_add(out, "; %d beyond the shape left out", d->left_out);
    batten_text_add(out, "\n");
}

static void text_distances(batten_text *out, const bat_check *check, const bat_checked *c)
{
    for (int i = 0; i < c->distance_count; i++)
        text_distance(out, check, &c->distances[i]);
    if (c->fold.found) {
        const double at[3] = {c->fold.point.x, c->fold.point.y, c->fold.point.z};
        batten_text_add(out, "    it folds over near ");
        for (int k = 0; k < 3; k++) {
            bat_report_rounded(out, at[k]);
            batten_text_add(out, k < 2 ? ", " : "\n");
        }
    }
    for (int i = 0; i < c->edge_count; i++)
        if (c->edges[i].is_near) {
            batten_text_add(out, "    the edge '%s' is at the centre plane within ",
                            c->edges[i].name);
            bat_report_length(out, check, c->edges[i].gap);
            batten_text_add(out, "\n");
        }
}

/* How many sections of a family are fair, and which are not. */
static void text_family(batten_text *out, const bat_checked *c, const char *family)
{
    int found = 0, fair = 0, missed = 0;
    for (int i = 0; i < c->section_count; i++) {
        const bat_section *s = &c->sections[i];
        if (strcmp(s->family, family) != 0)
            continue;
        found += s->found;
        missed += !s->found;
        fair += s->found && s->excess == 0;
    }
    if (found + missed == 0)
        return;
    batten_text_add(out, "    %ss: %d of %d without visible inflections in excess", family,
                    fair, found);
    if (missed)
        batten_text_add(out, "; %d could not be judged", missed);
    batten_text_add(out, "\n");
    for (int i = 0; i < c->section_count; i++) {
        const bat_section *s = &c->sections[i];
        if (strcmp(s->family, family) != 0 || !s->found || s->excess == 0)
            continue;
        batten_text_add(out, "      %s at ", s->name);
        bat_report_rounded(out, s->at);
        batten_text_add(out, ": ");
        add_plural(out, s->visible, "visible inflection");
        batten_text_add(out, ", %d in excess; largest curvature ", s->excess);
        bat_report_rounded(out, s->fairness.max_curvature);
        batten_text_add(out, "\n");
    }
}

static void text_triangle_joins(batten_text *out, const bat_check *check, const bat_checked *c)
{
    batten_text_add(out, "; at ");
    add_plural(out, c->triangle_joins, "inner edge");
    batten_text_add(out, " gaps of at most ");
    bat_report_length(out, check, c->triangle_gap);
    batten_text_add(out, ", normals turn by at most ");
    bat_report_rounded(out, c->triangle_angle);
    batten_text_add(out, " rad");
}

static void text_triangles(batten_text *out, const bat_check *check, const bat_checked *c)
{
    batten_text_add(out, "    ");
    add_plural(out, batten_triangles_count(c->object->triangles), "triangle");
    batten_text_add(out, " of degree %d", batten_triangles_degree(c->object->triangles));
    if (c->triangle_joins)
        text_triangle_joins(out, check, c);
    batten_text_add(out, "\n");
}

static void text_object(batten_text *out, const bat_check *check, const bat_checked *c)
{
    batten_text_add(out, "  %s (%s)\n", c->object->name, bat_kind_name(c->object));
    if (c->has_fairness) {
        batten_text_add(out, "    ");
        text_fairness(out, &c->fairness);
        batten_text_add(out, "\n");
    }
    if (c->knot_count)
        batten_text_add(out, "    joins at %d knot%s, all at least C%d and G%d\n",
                        c->knot_count, bat_plural(c->knot_count), c->parametric, c->geometric);
    if (c->object->kind == BATTEN_OBJECT_BODY || c->object->kind == BATTEN_OBJECT_MESH)
        bat_solid_text(c->object, &c->faults, out);
    if (c->object->kind == BATTEN_OBJECT_TRIANGLES)
        text_triangles(out, check, c);
    text_distances(out, check, c);
    static const char *const families[] = {"station",   "waterline", "buttock",
                                           "x section", "z section", "y section"};
    for (int k = 0; k < 6; k++)
        text_family(out, c, families[k]);
}

/* What is judged: the demands on a hull are others than those on a curve. */
static const char *purpose_of(const bat_check *check)
{
    int curves = 0, shapes = 0;
    for (int i = 0; i < check->object_count; i++) {
        const batten_object_kind kind = check->objects[i].object->kind;
        if (kind == BATTEN_OBJECT_SURFACE && check->objects[i].is_hull)
            return "a hull";
        curves += kind == BATTEN_OBJECT_CURVE;
        shapes += kind != BATTEN_OBJECT_CURVE && kind != BATTEN_OBJECT_POINTS;
    }
    return shapes ? "a free surface" : curves > 1 ? "a family of curves" : "a curve";
}

/* "3 corners", with what separates it from what was said before. */
static bool text_reason(batten_text *out, const char **separator, int count, const char *what)
{
    if (count == 0)
        return false;
    batten_text_add(out, "%s", *separator);
    add_plural(out, count, what);
    *separator = ", ";
    return true;
}

static void text_turn(batten_text *out, int count, double turn)
{
    batten_text_add(out, count > 1 ? ", the sharpest of " : " of ");
    bat_report_rounded(out, turn * 180 / BAT_PI);
    batten_text_add(out, " degrees");
}

static void text_reasons(batten_text *out, const bat_check *check)
{
    const bat_unfairness *u = &check->unfairness;
    const char *separator = ": ";
    batten_text_add(out, "\nVerdict: %s as %s", bat_check_is_fair(check) ? "fair" : "not fair",
                    purpose_of(check));
    if (text_reason(out, &separator, u->corners, "corner"))
        text_turn(out, u->corners, u->largest_turn);
    if (text_reason(out, &separator, u->joint_corners, "corner")) {
        batten_text_add(out, " where two curves meet");
        text_turn(out, u->joint_corners, u->largest_joint);
    }
    if (text_reason(out, &separator, u->creases, "edge")) {
        batten_text_add(out, " with a crease");
        text_turn(out, u->creases, u->largest_crease);
    }
    if (text_reason(out, &separator, u->folds, "surface"))
        batten_text_add(out, u->folds > 1 ? " that fold over" : " that folds over");
    if (text_reason(out, &separator, u->curvature_jumps, "jump"))
        batten_text_add(out, " of curvature");
    if (text_reason(out, &separator, u->joint_jumps, "jump"))
        batten_text_add(out, " of curvature where two curves meet");
    if (text_reason(out, &separator, u->unbounded, "place"))
        batten_text_add(out, " of unbounded curvature");
    if (text_reason(out, &separator, u->edge_jumps, "edge"))
        batten_text_add(out, " with a jump of curvature");
    if (text_reason(out, &separator, u->inflections, "inflection"))
        batten_text_add(out, " in excess");
}

/* Without a curve that was judged there is no verdict, but what would make one. */
static void text_verdict(batten_text *out, const bat_check *check)
{
    bool has_shape = false;
    for (int i = 0; i < check->object_count; i++)
        has_shape |= check->objects[i].object->curve || check->objects[i].object->surface ||
                     check->objects[i].object->triangles || check->objects[i].object->body ||
                     check->objects[i].object->mesh;
    if (check->judged_count)
        text_reasons(out, check);
    else if (has_shape)
        batten_text_add(
            out,
            "\n"
            "No verdict: fairness is judged of curves, of surfaces with their points, and of edges where surfaces meet");
    else
        batten_text_add(
            out,
            "\n"
            "No verdict: points alone are not judged; 'batten fair' makes them fair, 'batten fit' a curve or a surface through them");
}

/* Bodies hold together within the bound, meshes are closed or not. */
static void text_solids(batten_text *out, const bat_check *check, int bodies, int meshes)
{
    if (bodies) {
        batten_text_add(out, "; bodies%s %s within ", meshes ? " and meshes" : "",
                        check->ok ? "hold together" : "do not hold together");
        bat_report_length(out, check, check->within);
    } else if (meshes == 1) {
        batten_text_add(out, "; the mesh is %s", check->ok ? "closed" : "not closed");
    } else {
        batten_text_add(out, "; %s",
                        check->ok ? "the meshes are closed" : "not all meshes are closed");
    }
}

/* Of bodies the bound is for gaps, of other shapes for the points given. */
static void text_bound(batten_text *out, const bat_check *check)
{
    bool has_points = false;
    int bodies = 0, meshes = 0;
    for (int i = 0; i < check->object_count; i++) {
        has_points |= check->objects[i].distance_count > 0;
        bodies += check->objects[i].object->kind == BATTEN_OBJECT_BODY;
        meshes += check->objects[i].object->kind == BATTEN_OBJECT_MESH;
    }
    if (!has_points && check->bounded_count) {
        text_solids(out, check, bodies, meshes);
        return;
    }
    if (!check->bounded_count) {
        batten_text_add(out, "; there are no points to measure against ");
        bat_report_length(out, check, check->within);
        return;
    }
    batten_text_add(out, "; the points given %s ",
                    check->ok ? "lie within" : "lie farther than");
    bat_report_length(out, check, check->within);
    batten_text_add(out, check->ok ? " of the shape" : " from the shape");
}

void bat_report_text(const bat_check *check, batten_text *out)
{
    const bat_document *d = check->run->document;
    if (d->title)
        batten_text_add(out, "%s\n\n", d->title);
    batten_text_add(out, "What was done\n");
    for (int k = 0; k < d->feature_count; k++)
        if (check->upstream[d->order[k]])
            text_feature(out, check, &check->run->results[d->order[k]].shown);
    batten_text_add(out, "\nThe result\n");
    for (int i = 0; i < check->object_count; i++)
        text_object(out, check, &check->objects[i]);
    bat_joins_text(check, out);
    text_verdict(out, check);
    if (isfinite(check->within))
        text_bound(out, check);
    batten_text_add(out, ".\n");
}
