/* The report of a check as JSON, with all digits. */
#include "base/plural.h"
#include "design/outputs/corrections.h"
#include "design/outputs/report_parts.h"

static void json_fairness(batten_text *out, const batten_fairness *f)
{
    batten_text_add(
        out,
        "\"fairness\": {\"fair\": %s, \"inflections\": %d, \"excess_inflections\": %d, "
        "\"curvature_extrema\": %d, ",
        f->fair ? "true" : "false", f->inflections, f->excess_inflections,
        f->curvature_extrema);
    bat_report_number(out, "jumps", f->jumps);
    batten_text_add(out, ", ");
    bat_report_number(out, "energy", f->energy);
    batten_text_add(out, ", ");
    bat_report_number(out, "variation", f->variation);
    batten_text_add(out, ", ");
    bat_report_number(out, "max_curvature", f->max_curvature);
    batten_text_add(
        out,
        ", \"corners\": %d, \"curvature_jumps\": %d, \"halts\": %d, \"cusps\": %d, \"unbounded\": %d, ",
        f->corners, f->curvature_jumps, f->halts, f->cusps, f->unbounded);
    bat_report_number(out, "energy_error", f->energy_error);
    batten_text_add(out, ", ");
    bat_report_number(out, "variation_error", f->variation_error);
    batten_text_add(out, ", ");
    bat_report_number(out, "largest_turn", f->largest_turn);
    batten_text_add(out, ", ");
    bat_report_number(out, "largest_jump", f->largest_jump);
    batten_text_add(out, "}");
}

static void json_moves(batten_text *out, const batten_feature_result *r)
{
    const batten_fair_report *f = r->fairing;
    batten_text_add(out, ", \"moved\": {");
    bat_report_number(out, "max", f->max_move);
    batten_text_add(out, ", ");
    bat_report_number(out, "rms", f->rms_move);
    batten_text_add(out, ", \"count\": %d, \"set\": %d, \"index\": %d, \"control_points\": %s}",
                    f->moved_count, f->worst_set + 1, f->worst_index + 1,
                    f->control_points ? "true" : "false");
    batten_text_add(out,
                    ", \"excess_inflections\": {\"before\": %d, \"after\": %d}, \"energy\": {",
                    f->before.excess_inflections, f->after.excess_inflections);
    bat_report_number(out, "before", f->before.energy);
    batten_text_add(out, ", ");
    bat_report_number(out, "after", f->after.energy);
    batten_text_add(out, "}, \"suspects\": %d", f->suspect_count);
}

static void json_skin(batten_text *out, const batten_surface_skin_report *s)
{
    static const char *const cures[] = {"none", "stretched", "rescaled", "polynomial"};
    batten_text_add(out, ", \"skin\": {");
    bat_report_number(out, "deviation", s->error);
    batten_text_add(out, ", \"worst_section\": %d, \"exact_knots\": %d, \"knots\": %d, ",
                    s->worst_section + 1, s->exact_knot_count, s->knot_count);
    bat_report_number(out, "span_ratio", s->span_ratio);
    batten_text_add(out, ", ");
    bat_report_number(out, "normal_jump", s->normal_jump);
    batten_text_add(out, ", ");
    bat_report_number(out, "speed_jump", s->speed_jump);
    batten_text_add(out, ", ");
    bat_report_number(out, "crease", s->crease);
    batten_text_add(out, ", \"cure\": \"%s\", \"reversed\": %d, \"turned\": %d, ",
                    cures[s->cure], s->reversed_count, s->turned_count);
    batten_text_add(out, "\"crossings\": %d, \"disorders\": %d}", s->crossing_count,
                    s->disorder_count);
}

static void json_error(batten_text *out, const batten_feature_result *r)
{
    batten_text_add(out, ", \"error\": {");
    bat_report_number(out, "max", r->error_max);
    batten_text_add(out, ", ");
    bat_report_number(out, "rms", r->error_rms);
    batten_text_add(out, "}");
}

/* Warps in radians. */
static void json_plank(batten_text *out, const batten_loft_warp *w)
{
    batten_text_add(out, "{\"panel\": %d, ", w->panel + 1);
    bat_report_number(out, "median", w->median);
    batten_text_add(out, ", ");
    bat_report_number(out, "of_90", w->most);
    batten_text_add(out, ", ");
    bat_report_number(out, "largest", w->largest);
    batten_text_add(out, ", ");
    bat_report_number(out, "x_below", w->at[0]);
    batten_text_add(out, ", ");
    bat_report_number(out, "x_above", w->at[1]);
    batten_text_add(out, "}");
}

static void json_loft(batten_text *out, const batten_loft_report *l)
{
    batten_text_add(out, ", \"loft\": {");
    bat_report_number(out, "max", l->max_move);
    batten_text_add(out, ", ");
    bat_report_number(out, "rms", l->rms_move);
    batten_text_add(out, ", \"station\": %d, \"point\": %d, ", l->worst_station + 1,
                    l->worst_index + 1);
    bat_report_number(out, "height", l->height);
    batten_text_add(out,
                    ", \"sections\": %d, \"in_excess\": %d, \"excess_inflections\": %d, "
                    "\"rounds\": %d, \"faired_error\": ",
                    l->cut_count, l->cuts_in_excess, l->excess_inflections, l->rounds);
    batten_text_number(out, l->faired_error);
    batten_text_add(out, ", \"corrections\": [");
    for (int k = 0; k < l->correction_count; k++) {
        const bat_correction c = bat_loft_correction_at(l, k);
        batten_text_add(out, k ? ", " : "");
        bat_correction_as_json(&c, out);
    }
    batten_text_add(out, l->warp_count > 0 ? "], \"planks\": [" : "");
    for (int k = 0; k < l->warp_count; k++) {
        batten_text_add(out, k ? ", " : "");
        json_plank(out, l->warps + k);
    }
    batten_text_add(out, "]}");
}

static void json_feature(batten_text *out, const batten_feature_result *r)
{
    batten_text_add(out, "    {\"name\": ");
    batten_text_json(out, r->name);
    batten_text_add(out, ", \"operation\": \"%s\"", r->operation);
    if (r->has_error)
        json_error(out, r);
    if (r->fairing)
        json_moves(out, r);
    if (r->skin)
        json_skin(out, r->skin);
    if (r->loft)
        json_loft(out, r->loft);
    batten_text_add(out, "}");
}

static void json_distances(batten_text *out, const bat_checked *c)
{
    batten_text_add(out, ",\n     \"distances\": [");
    for (int i = 0; i < c->distance_count; i++) {
        const bat_data_distance *d = &c->distances[i];
        batten_text_add(out, "%s{\"from\": ", i ? ", " : "");
        batten_text_json(out, d->feature);
        batten_text_add(out, ", \"faired\": %s, \"points\": %d, ",
                        d->is_faired ? "true" : "false", d->count);
        bat_report_number(out, "max", d->max);
        batten_text_add(out, ", ");
        bat_report_number(out, "rms", d->rms);
        batten_text_add(out, ", ");
        if (d->count)
            bat_report_point(out, "at", d->worst);
        else
            batten_text_add(out, "\"at\": null");
        batten_text_add(out, ", \"left_out\": %d}", d->left_out);
    }
    batten_text_add(out, "]");
}

static void json_surface(batten_text *out, const bat_checked *c)
{
    json_distances(out, c);
    batten_text_add(out, ",\n     \"edges\": [");
    for (int i = 0; i < c->edge_count; i++) {
        batten_text_add(out, "%s{\"name\": \"%s\", ", i ? ", " : "", c->edges[i].name);
        bat_report_number(out, "gap", c->edges[i].gap);
        batten_text_add(out, ", \"at_centre\": %s}", c->edges[i].is_near ? "true" : "false");
    }
    batten_text_add(out, "],\n     \"sections\": [");
    for (int i = 0; i < c->section_count; i++) {
        const bat_section *s = &c->sections[i];
        batten_text_add(out, "%s\n      {\"family\": \"%s\", \"name\": ", i ? "," : "",
                        s->family);
        batten_text_json(out, s->name);
        batten_text_add(out, ", ");
        bat_report_number(out, "at", s->at);
        if (s->found) {
            batten_text_add(out, ", ");
            batten_text_add(out, "\"visible_inflections\": %d, \"visible_excess\": %d, ",
                            s->visible, s->excess);
            json_fairness(out, &s->fairness);
        }
        batten_text_add(out, "}");
    }
    batten_text_add(out, "]");
}

static void json_triangles(batten_text *out, const bat_checked *c)
{
    batten_text_add(out, ", \"count\": %d, \"degree\": %d, \"inner_edges\": %d, ",
                    batten_triangles_count(c->object->triangles),
                    batten_triangles_degree(c->object->triangles), c->triangle_joins);
    bat_report_number(out, "gap", c->triangle_gap);
    batten_text_add(out, ", ");
    bat_report_number(out, "angle", c->triangle_angle);
}

static void json_object(batten_text *out, const bat_checked *c)
{
    batten_text_add(out, "    {\"name\": ");
    batten_text_json(out, c->object->name);
    batten_text_add(out, ", \"type\": \"%s\"", bat_kind_name(c->object));
    if (c->has_fairness) {
        batten_text_add(out, ", ");
        json_fairness(out, &c->fairness);
    }
    if (c->knot_count)
        batten_text_add(out, ", \"continuity\": {\"knots\": %d, \"c\": %d, \"g\": %d}",
                        c->knot_count, c->parametric, c->geometric);
    if (c->object->kind == BATTEN_OBJECT_SURFACE)
        json_surface(out, c);
    else if (c->object->kind == BATTEN_OBJECT_TRIANGLES)
        json_triangles(out, c);
    else if (c->object->kind == BATTEN_OBJECT_BODY || c->object->kind == BATTEN_OBJECT_MESH)
        bat_solid_json(c->object, &c->faults, out);
    else if (c->distance_count)
        json_distances(out, c);
    batten_text_add(out, "}");
}

static void json_message(batten_text *out, const batten_note *note)
{
    batten_text_add(out, "    {\"file\": ");
    batten_text_json(out, note->file);
    batten_text_add(out, ", \"line\": %d, \"entity\": ", note->line);
    batten_text_json(out, note->entity);
    batten_text_add(out, ", \"text\": ");
    batten_text_json(out, note->text);
    batten_text_add(out, ", \"remark\": %s}", note->is_remark ? "true" : "false");
}

static void json_messages(batten_text *out, const batten_notes *notes)
{
    for (int i = 0; notes && i < batten_notes_count(notes); i++) {
        batten_text_add(out, "%s\n", i ? "," : "");
        json_message(out, batten_notes_at(notes, i));
    }
}

void bat_report_json(const bat_check *check, batten_text *out)
{
    const bat_document *d = check->run->document;
    batten_text_add(out, "{\n  \"ok\": %s, \"fair\": %s, \"unit\": \"%s\", ",
                    check->ok ? "true" : "false",
                    check->judged_count == 0   ? "null"
                    : bat_check_is_fair(check) ? "true"
                                               : "false",
                    bat_check_unit(check));
    bat_report_number(out, "within", check->within);
    batten_text_add(out, ",\n  \"features\": [");
    for (int k = 0, count = 0; k < d->feature_count; k++)
        if (check->upstream[d->order[k]]) {
            batten_text_add(out, count++ ? ",\n" : "\n");
            json_feature(out, &check->run->results[d->order[k]].shown);
        }
    batten_text_add(out, "\n  ],\n  \"objects\": [");
    for (int i = 0; i < check->object_count; i++) {
        batten_text_add(out, i ? ",\n" : "\n");
        json_object(out, &check->objects[i]);
    }
    batten_text_add(
        out,
        "\n  ],\n  \"corners_where_curves_meet\": %d, \"jumps_where_curves_meet\": %d, "
        "\"creases\": %d, \"edge_jumps\": %d, \"folds\": %d,\n  \"joins\": [",
        check->unfairness.joint_corners, check->unfairness.joint_jumps, check->unfairness.creases, check->unfairness.edge_jumps, check->unfairness.folds);
    bat_joins_json(check, out);
    batten_text_add(out, "],\n  \"worst_joins\": [");
    bat_worst_joins_json(check, out);
    batten_text_add(out, "],\n  \"messages\": [");
    json_messages(out, check->run->notes);
    batten_text_add(out, "]\n}\n");
}
