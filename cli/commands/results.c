/* What is printed when features were evaluated: times, errors, moves, as lines or as JSON. */
#include "commands/results.h"

#include <batten/design.h>
#include <batten/text.h>
#include <stdio.h>

static void add_member(batten_text *text, const char *key, double value)
{
    batten_text_add(text, "\"%s\": ", key);
    batten_text_number(text, value);
}

static void error_json(batten_text *text, const batten_feature_result *r)
{
    batten_text_add(text, ", \"error\": {");
    add_member(text, "max", r->error_max);
    batten_text_add(text, ", ");
    add_member(text, "rms", r->error_rms);
    batten_text_add(text, "}");
}

static void moves_json(batten_text *text, const batten_feature_result *r)
{
    batten_text_add(text, ", \"moved\": {");
    add_member(text, "max", r->move_max);
    batten_text_add(text, ", \"count\": %d}", r->moved_count);
}

static void feature_json(batten_text *text, const batten_feature_result *r)
{
    batten_text_add(text, "{\"name\": ");
    batten_text_json(text, r->name);
    batten_text_add(text, ", \"operation\": ");
    batten_text_json(text, r->operation);
    batten_text_add(text, ", \"status\": \"%s\", ", batten_status_name(r->status));
    add_member(text, "seconds", r->seconds);
    if (r->has_error)
        error_json(text, r);
    if (r->has_moves)
        moves_json(text, r);
    if (r->fairing)
        batten_text_add(text, ", \"excess_inflections\": {\"before\": %d, \"after\": %d}",
                        r->fairing->before.excess_inflections,
                        r->fairing->after.excess_inflections);
    batten_text_add(text, "}");
}

void results_json(batten_text *text, const batten_design *design, int output_count,
                  const char *const *outputs, const batten_notes *notes)
{
    batten_text_add(text, "{\"features\": [");
    for (int i = 0; i < batten_design_result_count(design); i++) {
        batten_text_add(text, "%s\n    ", i ? "," : "");
        feature_json(text, batten_design_result_at(design, i));
    }
    batten_text_add(text, "],\n  \"outputs\": [");
    for (int i = 0; i < output_count; i++) {
        batten_text_add(text, "%s", i ? ", " : "");
        batten_text_json(text, outputs[i]);
    }
    batten_text_add(text, "],\n  \"messages\": ");
    notes_json(text, notes);
    batten_text_add(text, "}\n");
}

static void feature_text(batten_text *text, const batten_feature_result *r, const char *unit)
{
    batten_text_add(text, "%-14s %-12s", r->name, r->operation);
    if (r->status != BATTEN_OK && r->status != BATTEN_PARTLY_READ)
        batten_text_add(text, " failed");
    if (r->has_error)
        batten_text_add(text, "  error at most %.3g %s", r->error_max, unit);
    const bool control_points = r->fairing && r->fairing->control_points;
    if (r->has_moves)
        batten_text_add(text, "  %d %spoint%s moved, %sat most %.3g %s", r->moved_count,
                        control_points ? "control " : "", r->moved_count == 1 ? "" : "s",
                        control_points ? "the curve by " : "", r->move_max, unit);
    if (r->fairing)
        batten_text_add(text, ", excess inflections %d -> %d",
                        r->fairing->before.excess_inflections,
                        r->fairing->after.excess_inflections);
    if (r->skin && r->skin->exact_knot_count != r->skin->knot_count)
        batten_text_add(text, ", knots %d -> %d", r->skin->exact_knot_count,
                        r->skin->knot_count);
    batten_text_add(text, "\n");
}

void results_text(batten_text *text, const batten_design *design, int output_count,
                  const char *const *outputs)
{
    const char *unit = batten_unit_name(batten_design_unit_metres(design));
    for (int i = 0; i < batten_design_result_count(design); i++)
        feature_text(text, batten_design_result_at(design, i), unit ? unit : "");
    for (int i = 0; i < output_count; i++)
        batten_text_add(text, "wrote %s\n", outputs[i]);
}
