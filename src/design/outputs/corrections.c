/* The output 'corrections': which points of a table or of curves were moved, how far, and why. */
#include "design/outputs/corrections.h"
#include "base/arena.h"
#include "design/feature.h"
#include "numeric/vector.h"

#include <stdlib.h>
#include <string.h>

static const batten_parameter parameters[] = {
    {"corrections", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "what was lofted or faired"},
};

/* ---- the list ---- */

static const char *line_of(const batten_offset_table *table, int station, int index)
{
    const int line = batten_offset_table_station(table, station)->points[index].line;
    return line >= 0 ? batten_offset_table_line(table, line)->name : "";
}

bat_correction bat_loft_correction_at(const batten_loft_report *report, int index)
{
    static const char *const reasons[] = {"noise", "bound", "suspect"};
    const batten_loft_correction *c = report->corrections + index;
    return (bat_correction){batten_offset_table_label(report->faired, c->station),
                            c->station,
                            c->index,
                            line_of(report->faired, c->station, c->index),
                            c->from,
                            c->to,
                            c->distance,
                            reasons[c->reason]};
}

/* The energy is the least to this part of a bound. */
static const double least_of_bound = 1e-6;

/* Points that a search left at their bound would move farther. Control points have balls of their own (bound 0). */
static const char *reason_of(const batten_fair_move *move, double bound)
{
    const double distance = bat_distance(3, move->from, move->to);
    return bound > 0 && distance >= (1 - least_of_bound) * bound ? "bound" : "noise";
}

/* `table`: of what was faired; NULL for curves, of which `what` moved. */
static bat_correction move_of(const batten_fair_move *move, const batten_offset_table *table,
                              const char *what, const char *reason)
{
    bat_correction c = {.set = move->set,
                        .index = move->index,
                        .line = "",
                        .from = move->from,
                        .to = move->to,
                        .distance = bat_distance(3, move->from, move->to),
                        .reason = reason};
    if (table) {
        c.place = batten_offset_table_label(table, move->set);
        c.line = line_of(table, move->set, move->index);
    } else {
        batten_text_print(c.place.text, sizeof c.place.text, "%s %d", what, move->set + 1);
    }
    return c;
}

typedef struct {
    int count;
    bat_correction *at;
} corrections;

/* Equal distances in the order of curves and points, whatever qsort does with them. */
static int farthest_first(const void *a, const void *b)
{
    const bat_correction *p = a, *q = b;
    if (p->distance != q->distance)
        return p->distance < q->distance ? 1 : -1;
    return p->set != q->set ? p->set - q->set : p->index - q->index;
}

/* The table that was faired, where it is the only object; else NULL. */
static const batten_offset_table *only_table(const batten_model *model)
{
    if (batten_model_count(model) != 1)
        return NULL;
    const batten_object *object = batten_model_object(model, 0);
    return object->kind == BATTEN_OBJECT_OFFSET_TABLE ? object->offset_table : NULL;
}

static batten_status collect_moves(const bat_result *result, bat_arena *arena, corrections *out)
{
    const batten_fair_report *f = &result->fairing;
    const batten_offset_table *table = only_table(result->value);
    const char *what = f->control_points ? "control points of curve" : f->net ? "row" : "curve";
    out->at = bat_arena_array(arena, (size_t)f->move_count + (size_t)f->suspect_count,
                              sizeof *out->at);
    if (!out->at)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < f->move_count; k++)
        out->at[out->count++] =
            move_of(f->moves + k, table, what, reason_of(f->moves + k, result->fairing_bound));
    for (int k = 0; k < f->suspect_count; k++)
        out->at[out->count++] = move_of(f->suspects + k, table, what, "suspect");
    qsort(out->at, (size_t)out->count, sizeof *out->at, farthest_first);
    return BATTEN_OK;
}

static batten_status collect(const bat_run *run, bat_arena *arena, corrections *out)
{
    const bat_item *item = bat_argument_of(run, "corrections")->items;
    const bat_result *result = run->results + item->count;
    const batten_loft_report *loft = result->shown.loft;
    if (result->shown.has_moves)
        return collect_moves(result, arena, out);
    if (!loft)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "'%.60s' is neither lofted nor faired, and has no corrections: name the "
            "feature with 'loft', 'fair' or 'fair-net'",
            item->text);
    out->at = bat_arena_array(arena, (size_t)loft->correction_count, sizeof *out->at);
    if (!out->at)
        return BATTEN_OUT_OF_MEMORY;
    for (out->count = 0; out->count < loft->correction_count; out->count++)
        out->at[out->count] = bat_loft_correction_at(loft, out->count);
    return BATTEN_OK;
}

/* ---- text, JSON, CSV ---- */

static void add_change(const char *what, double from, double to, batten_text *out)
{
    if (from != to)
        batten_text_add(out, ", %s %.6g -> %.6g", what, from, to);
}

void bat_correction_as_text(const bat_correction *c, const char *unit, batten_text *out)
{
    batten_text_add(out, "%s, ", c->place.text);
    if (*c->line)
        batten_text_add(out, "%s", c->line);
    else
        batten_text_add(out, "point %d", c->index + 1);
    add_change("x", c->from[0], c->to[0], out);
    add_change("y", c->from[1], c->to[1], out);
    add_change("z", c->from[2], c->to[2], out);
    batten_text_add(out, ": %.4g%s%s off, %s", c->distance, *unit ? " " : "", unit, c->reason);
}

static void json_point(const char *name, const double p[3], batten_text *out)
{
    batten_text_add(out, ", \"%s\": [", name);
    for (int c = 0; c < 3; c++) {
        batten_text_add(out, "%s", c ? ", " : "");
        batten_text_number(out, p[c]);
    }
    batten_text_add(out, "]");
}

void bat_correction_as_json(const bat_correction *c, batten_text *out)
{
    batten_text_add(out, "{\"place\": ");
    batten_text_json(out, c->place.text);
    batten_text_add(out, ", \"point\": %d, \"line\": ", c->index + 1);
    batten_text_json(out, c->line);
    json_point("from", c->from, out);
    json_point("to", c->to, out);
    batten_text_add(out, ", \"distance\": ");
    batten_text_number(out, c->distance);
    batten_text_add(out, ", \"reason\": \"%s\"}", c->reason);
}

static void write_text(const bat_run *run, const corrections *all, batten_text *out)
{
    for (int k = 0; k < all->count; k++) {
        bat_correction_as_text(all->at + k, bat_unit_name(run), out);
        batten_text_add(out, "\n");
    }
    batten_text_add(out,
                    "noise: within the bound, evened out; bound: held at it, and would move "
                    "farther; suspect: look it up\n");
}

static void write_json(const corrections *all, batten_text *out)
{
    batten_text_add(out, "[\n");
    for (int k = 0; k < all->count; k++) {
        bat_correction_as_json(all->at + k, out);
        batten_text_add(out, k + 1 < all->count ? ",\n" : "\n");
    }
    batten_text_add(out, "]\n");
}

/* Of a name with commas or quotes. */
static void add_quoted(const char *text, batten_text *out)
{
    const bool plain = !strpbrk(text, ",\"\n\r");
    batten_text_add(out, plain ? "" : "\"");
    for (; *text; text++) {
        if (*text == '"')
            batten_text_bytes(out, "\"", 1);
        batten_text_bytes(out, text, 1);
    }
    batten_text_add(out, plain ? "," : "\",");
}

static void write_csv(const corrections *all, batten_text *out)
{
    batten_text_add(out, "place,point,line,x,y,z,to_x,to_y,to_z,distance,reason\n");
    for (int k = 0; k < all->count; k++) {
        const bat_correction *c = all->at + k;
        add_quoted(c->place.text, out);
        batten_text_add(out, "%d,", c->index + 1);
        add_quoted(c->line, out);
        for (int i = 0; i < 7; i++) {
            batten_text_number(out, i < 3 ? c->from[i] : i < 6 ? c->to[i - 3] : c->distance);
            batten_text_add(out, ",");
        }
        batten_text_add(out, "%s\n", c->reason);
    }
}

static batten_status run_corrections(bat_run *run)
{
    const char *dot = strrchr(run->name, '.');
    bat_arena arena = {0};
    corrections all = {0};
    batten_text text = BATTEN_TEXT;
    batten_status status = collect(run, &arena, &all);
    if (status != BATTEN_OK) {
        bat_arena_free(&arena);
        return status;
    }
    if (dot && strcmp(dot, ".json") == 0)
        write_json(&all, &text);
    else if (dot && strcmp(dot, ".csv") == 0)
        write_csv(&all, &text);
    else
        write_text(run, &all, &text);
    status = batten_text_take(&text, &run->data, &run->size);
    batten_text_free(&text);
    bat_arena_free(&arena);
    return status;
}

const bat_feature bat_feature_corrections = {
    .shown =
        {"corrections", "A list: which points lofting or fairing moved, how far, and why",
         "A row for each point that moved, the farthest first: its station and line, or curve and\n"
         "point, where it was, where it is, and how far that is. The reason is one word: 'noise'\n"
         "when the point was evened out within its bound, 'bound' when it is held at its bound and\n"
         "would move farther, 'suspect' when it stands out alone among its neighbours: it may be a\n"
         "wrong digit, and is never changed for that. Suspects of 'fair' are listed with the place\n"
         "that is suggested, which was not carried out. Where 'fair' moved control points these are\n"
         "listed, and may have gone farther than the curve. As JSON when the file ends in .json,\n"
         "CSV with all digits when it ends in .csv; else text. 'faired-table' makes the table itself.",
         "features:\n"
         "  table: {read: offsets.csv}\n"
         "  hull: {loft: table, within: 3 mm}\n"
         "outputs:\n"
         "  corrections.csv: {corrections: hull}\n",
         "", "batten_hull_loft", BAT_PARAMETERS(parameters), true,
         .also = "list of corrections, moved points, blunders, wrong offsets, mould loft, "
                 "differences from the table"},
    .run = run_corrections};
