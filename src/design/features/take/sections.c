/* The feature 'sections': stations, waterlines and buttocks of surfaces as curves. */
#include "base/plural.h"
#include "design/features/take/contour_curves.h"
#include "design/features/take/section_proof.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const batten_parameter parameters[] = {
    {"sections", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "surfaces"},
    {"stations", BATTEN_VALUE_LENGTH, true, false, NULL, NULL, "x of planes across"},
    {"buttocks", BATTEN_VALUE_LENGTH, true, false, NULL, NULL, "y of planes lengthwise"},
    {"waterlines", BATTEN_VALUE_LENGTH, true, false, NULL, NULL, "z of level planes"},
    {"flat", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "each laid into the plane z = 0: stations as (y, z), buttocks as (x, z)"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how close the curves are to the sections; the tolerance of the design by default"},
    {"as", BATTEN_VALUE_WORD, false, false, "curves", "curves polylines",
     "smooth curves with few control points, or chords"},
};

/* By the coordinate that is fixed in their planes; those that lie right and up in them. */
static const struct {
    const char *layer, *one;
    int right, up;
} families[] = {{"stations", "station", 1, 2},
                {"buttocks", "buttock", 0, 2},
                {"waterlines", "waterline", 0, 1}};
enum { FAMILIES = sizeof families / sizeof families[0] };
static const char letters[] = "xyz";

typedef struct {
    bat_contours_wanted wanted;
    int axis;
    bool flat;
    int count, unproved; /* sections: a plane and a surface each */
    char first[240];     /* of those not proved */
} cutting;

static int compare_levels(const void *a, const void *b)
{
    const double one = *(const double *)a, other = *(const double *)b;
    return (one > other) - (one < other);
}

/* The planes of a family by increasing place, each once. */
static batten_status take_levels(const bat_run *run, cutting *c)
{
    const bat_argument *given = bat_argument_of(run, families[c->axis].layer);
    double *levels = bat_array((size_t)given->count, sizeof *levels);
    int count = 0;
    if (!levels)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < given->count; i++)
        levels[i] = given->items[i].number[0];
    qsort(levels, (size_t)given->count, sizeof *levels, compare_levels);
    for (int i = 0; i < given->count; i++)
        if (count == 0 || levels[i] != levels[count - 1])
            levels[count++] = levels[i];
    c->wanted.levels = levels;
    c->wanted.level_count = count;
    return BATTEN_OK;
}

static batten_status lay_flat(int axis, batten_curve **curve)
{
    batten_affine map = {.m = {{0}}};
    batten_curve *flat = NULL;
    map.m[0][families[axis].right] = 1;
    map.m[1][families[axis].up] = 1;
    const batten_status status = batten_curve_transform(*curve, &map, &flat);
    if (status == BATTEN_OK) {
        batten_curve_unref(*curve);
        *curve = flat;
    }
    return status;
}

static batten_status put_section(bat_run *run, const batten_object *object, cutting *c,
                                 const batten_contour *contour, double rise)
{
    char name[240];
    batten_curve *curve = NULL;
    batten_object like = *object;
    batten_text_print(name, sizeof name, "%.160s %s %.9g", object->name, families[c->axis].one,
                      c->wanted.levels[contour->level]);
    like.name = name;
    like.layer = families[c->axis].layer;
    batten_status status = bat_contour_curve(&c->wanted, contour, rise, &curve);
    if (status == BATTEN_OK && c->flat)
        status = lay_flat(c->axis, &curve);
    return bat_put_curve_like(run, status, curve, &like, false);
}

/* A remark on each plane that meets nothing; those with lines that may be missing are counted for one note. */
static void judge_section(const bat_run *run, const batten_object *object, cutting *c,
                          int level, int lines)
{
    const double at = c->wanted.levels[level];
    const bool is_proved = bat_section_is_proved(object->surface, c->axis, at, lines);
    c->count++;
    if (lines == 0 && is_proved)
        bat_remark(run, "'%s' does not meet the plane %c = %g", object->name, letters[c->axis],
                   at);
    if (is_proved)
        return;
    if (c->unproved++ == 0)
        batten_text_print(c->first, sizeof c->first, "%c = %g of '%.160s'", letters[c->axis],
                          at, object->name);
}

static batten_status cut_object(bat_run *run, const batten_object *object, cutting *c)
{
    batten_contours found = {0};
    batten_status status = bat_contours_find_fine(run, object, &c->wanted, &found);
    int next = 0;
    for (int level = 0; level < c->wanted.level_count && status == BATTEN_OK; level++) {
        const int begin = next;
        for (; next < found.count && found.lines[next].level == level && status == BATTEN_OK;
             next++)
            status = put_section(run, object, c, &found.lines[next], found.error);
        if (status == BATTEN_OK)
            judge_section(run, object, c, level, next - begin);
    }
    batten_contours_release(&found);
    return status;
}

static batten_status cut_family(bat_run *run, const bat_objects *surfaces, cutting *c)
{
    c->wanted.field = (batten_surface_field){
        .kind = BATTEN_FIELD_HEIGHT, .direction = {c->axis == 0, c->axis == 1, c->axis == 2}};
    batten_status status = take_levels(run, c);
    for (int i = 0; i < surfaces->count && status == BATTEN_OK; i++)
        status = cut_object(run, surfaces->at[i], c);
    bat_release(c->wanted.levels);
    c->wanted.levels = NULL;
    return status;
}

static void note_proofs(const bat_run *run, const cutting *c)
{
    if (c->unproved > 0)
        bat_note(
            run,
            "%d of %d section%s %s not proved complete, the first at %s: a line shorter than "
            "the triangles of the search may be missing",
            c->unproved, c->count, bat_plural(c->count),
            bat_one_or_many(c->unproved, "is", "are"), c->first);
    else
        bat_remark(run, "%d section%s, proved complete", c->count, bat_plural(c->count));
}

static batten_status run_sections(bat_run *run)
{
    bat_objects surfaces;
    if (!bat_has(run, "stations") && !bat_has(run, "buttocks") && !bat_has(run, "waterlines"))
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "no plane is given: say where 'stations', 'buttocks' or 'waterlines' are");
    batten_status status = bat_gather(run, "sections", BAT_SURFACES, &surfaces);
    if (status != BATTEN_OK)
        return status;
    cutting c = {.flat = bat_yes(run, "flat")};
    c.wanted.within = bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    c.wanted.smooth = bat_word(run, "as") == 0;
    for (c.axis = 0; c.axis < FAMILIES && status == BATTEN_OK; c.axis++)
        if (bat_has(run, families[c.axis].layer))
            status = cut_family(run, &surfaces, &c);
    if (status == BATTEN_OK && batten_model_count(run->model) == 0)
        status = bat_fail(BATTEN_NOT_FOUND, "none of the planes meets a surface");
    if (status == BATTEN_OK) {
        note_proofs(run, &c);
        bat_report_error(run, c.wanted.error, c.wanted.error);
    }
    bat_objects_release(&surfaces);
    return status;
}

const bat_feature bat_feature_sections = {
    .shown =
        {"sections", "Plane sections of surfaces: stations, buttocks, waterlines",
         "Curves on the layers 'stations', 'buttocks' and 'waterlines', in space or, for frames\n"
         "and moulds, laid flat. Written as DXF each family has its layer. Sections are searched\n"
         "as 'contours' are; that none of their lines is missing is proved where the control\n"
         "points rise or fall strictly along the surface or lie on one side of the plane, and\n"
         "noted where it is not.",
         "features:\n"
         "  side: {bilinear: [[0, 0, 0], [4, 0, 0], [4, 1, 1.4], [0, 1, 1]]}\n"
         "  frames: {sections: side, stations: [1, 2, 3], waterlines: 0.5, flat: yes}\n"
         "outputs:\n"
         "  frames.dxf: frames\n",
         "", "batten_surface_contours", BAT_PARAMETERS(parameters), false,
         .also =
             "plane sections, frames, bulkheads, moulds, stations, waterlines, buttocks, slices, intersection with a plane"},
    .run = run_sections,
    .displacing = "sections"};
