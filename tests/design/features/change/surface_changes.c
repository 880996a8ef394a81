#include "support/test.h"

#include <batten/design.h>
#include <string.h>

/* A patch, a creased roof, a sphere and a curve. */
static const char common[] =
    "batten: 1\nunits: m\nfeatures:\n"
    "  net:\n    points: [[0, 0, 0], [0, 1, 0.2], [0, 2, 0.1], [1, 0, 0.3], [1, 1, 0.4], "
    "[1, 2, 0.3], [2, 0, 0], [2, 1, 0.2], [2, 2, 0]]\n    columns: 3\n"
    "  patch: {interpolate-grid: net}\n"
    "  other: {move: patch, by: [4, 0.5, 1]}\n"
    "  ball: {sphere: 2}\n"
    "  deck: {bilinear: [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]]}\n"
    "  wall: {bilinear: [[0, 0, 0], [0, 0, 2], [0, 3, 2], [0, 3, 0]]}\n"
    "  rail: {line: [[0, 0, 0], [1, 0, 0]]}\n"
    "  roof-line: {polyline: [[0, 0, 0], [1, 0, 1], [2, 0, 0]]}\n"
    "  roof: {extrude: roof-line, along: [0, 3, 0]}\n";

static batten_status evaluate(const char *feature, batten_notes *notes, batten_design **out)
{
    char text[3000];
    snprintf(text, sizeof text, "%s  x: %s\n", common, feature);
    batten_design *design = NULL;
    batten_status status = batten_design_parse(text, strlen(text), NULL, notes, &design);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(design, "x", NULL, notes);
    if (status == BATTEN_OK)
        *out = design;
    else
        batten_design_free(design);
    return status;
}

typedef struct {
    const char *feature;
    int count; /* of surfaces */
    const char *note;
} good_row;

static void check_good(int count, const good_row *rows)
{
    for (int i = 0; i < count; i++) {
        batten_notes *notes = NULL;
        batten_design *design = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(evaluate(rows[i].feature, notes, &design));
        const batten_model *model = batten_design_result(design, "x")->value;
        CHECK_INT(batten_model_count(model), rows[i].count);
        CHECK(batten_model_object(model, 0)->kind == BATTEN_OBJECT_SURFACE);
        bool said = batten_notes_dropped(notes) > 0; /* for lack of memory */
        for (int k = 0; k < batten_notes_count(notes); k++)
            said |= strstr(batten_notes_at(notes, k)->text, rows[i].note) != NULL;
        CHECK(said);
        batten_design_free(design);
        batten_notes_free(notes);
    }
}

typedef struct {
    const char *feature, *words;
    batten_status status;
} bad_row;

static void check_bad(int count, const bad_row *rows)
{
    for (int i = 0; i < count; i++) {
        batten_design *design = NULL;
        CHECK_STATUS(evaluate(rows[i].feature, NULL, &design), rows[i].status);
        CHECK_MESSAGE(rows[i].words);
    }
}

TEST(surfaces_are_offset)
{
    static const good_row rows[] = {
        {"{offset: ball, by: 0.5}", 1, "the offset is exact"},
        {"{offset: patch, by: 0.1, side: both}", 2, "within the tolerance"},
        {"{offset: patch, by: 9, side: both, turned: keep, within: 1 m}", 2, "turns over"},
    };
    check_good(COUNT(rows), rows);
}

TEST(G5_offsets_of_surfaces_that_turn_over_or_have_creases_are_refused)
{
    static const bad_row rows[] = {
        {"{offset: ball, by: -2}", "radius of curvature is only 2", BATTEN_SINGULAR_HERE},
        {"{offset: roof, by: 0.1}", "a crease of 90 degrees", BATTEN_NOT_COMPATIBLE},
    };
    check_bad(COUNT(rows), rows);
}

TEST(surfaces_are_made_longer)
{
    static const good_row rows[] = {
        {"{extend: patch, edges: [u0, v1], by: 0.5}", 1, "v1 is longer by"},
        {"{extend: patch, edges: u1, by: 0.5, shape: natural}", 1, "curvature by 0"},
        {"{extend: patch, edges: u1, by: 0.5, shape: line}", 1, "normal jumps by 0 degrees"},
    };
    check_good(COUNT(rows), rows);
}

TEST(G7_surfaces_that_cannot_be_made_longer_are_refused)
{
    static const bad_row rows[] = {
        {"{extend: patch, start: 1}", "is a surface", BATTEN_BAD_ARGUMENT},
        {"{extend: rail, edges: u0, by: 1}", "'start', 'end', 'from' or 'to'",
         BATTEN_BAD_ARGUMENT},
        {"{extend: ball, edges: v0, by: 1}", "is a point", BATTEN_SINGULAR_HERE},
    };
    check_bad(COUNT(rows), rows);
}

TEST(surfaces_are_blended)
{
    static const good_row rows[] = {
        {"{blend: [patch, other], edges: [u1, u0]}", 1, "normals jump by"},
        {"{blend: [patch, other], edges: [v1, v0], first: G1, bulge: [0.5, 1]}", 1,
         "the edges run"},
        {"{blend: [patch, other], edges: [u1, u0], parts: [0, 0.5, 0.5, 1], second: G0}", 1,
         "the edges run alike"},
    };
    check_good(COUNT(rows), rows);
}

TEST(G7_surfaces_that_cannot_be_blended_are_refused)
{
    static const bad_row rows[] = {
        {"{blend: [patch, other], edges: u1}", "two 'edges', 1", BATTEN_BAD_ARGUMENT},
        {"{blend: patch, edges: [u1, u0]}", "two surfaces are needed", BATTEN_NOT_COMPATIBLE},
        {"{blend: [patch, other], edges: [u1, u0], first: G3}", "side 1: continuity G3",
         BATTEN_BAD_ARGUMENT},
        {"{blend: [patch, other], edges: [u1, u0], parts: [0, 1]}", "four numbers",
         BATTEN_BAD_ARGUMENT},
        {"{blend: [patch, patch], edges: [u1, u1]}", "the edges are the same",
         BATTEN_COINCIDENT},
    };
    check_bad(COUNT(rows), rows);
}

TEST(fillets_roll_between_surfaces)
{
    static const good_row rows[] = {
        {"{fillet-surfaces: [deck, wall], radius: 0.3, sides: [left, right], contacts: yes}", 3,
         "arcs of 90 to 90 degrees"},
        {"{fillet-surfaces: [deck, wall], radius: 0.3, sides: [left, right], start: [0.2, 0.5, "
         "0.1, 0.5]}",
         1, "it ends at a border"},
    };
    check_good(COUNT(rows), rows);
}

TEST(G5_fillets_that_find_no_place_are_refused)
{
    static const bad_row rows[] = {
        {"{fillet-surfaces: [deck, wall], radius: 9, sides: [left, right]}", "no ball",
         BATTEN_NOT_FOUND},
        {"{fillet-surfaces: deck, radius: 1}", "two surfaces are needed",
         BATTEN_NOT_COMPATIBLE},
        {"{fillet-surfaces: [deck, wall], radius: 1, start: 0.5}", "four numbers",
         BATTEN_BAD_ARGUMENT},
    };
    check_bad(COUNT(rows), rows);
}
