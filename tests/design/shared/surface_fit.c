#include "design/shared/surface_fit.h"
#include "design/expect.h"

#include "design/text/document.h"
#include "support/test.h"

/* What is said of a surface near points: of reports that are made by hand, each figure in its place. */

#define FIT                                                                             \
    .error = 0.125, .rms = 0.0625, .most = 0.1, .where = {1.5, 2.25, 3}, .points_u = 4, \
    .points_v = 7
#define SAID \
    "4 x 7 control points: distance at most 0.125, at (1.5, 2.25, 3); rms 0.0625; 95 of 100 below 0.1"

static const struct {
    batten_surface_fit_report report;
    bool is_remark; /* of what is said after the first remark */
    const char *more;
} cases[] = {
    {{FIT, .layered = 0.2, .outside_share = 0.1}, true, NULL},
    {{FIT, .reweightings = 1, .threshold = 0.75},
     true,
     "points farther than 0.75 count less, after 1 round"},
    {{FIT, .reweightings = 3, .threshold = 0.75},
     true,
     "points farther than 0.75 count less, after 3 rounds"},
    {{FIT, .rounds = 1, .end = BATTEN_LEVELS_MET}, true, "1 level: every point is near enough"},
    {{FIT, .rounds = 2, .end = BATTEN_LEVELS_LARGE},
     true,
     "2 levels: the next would have too many control points"},
    {{FIT, .rounds = 2, .end = BATTEN_LEVELS_FEW},
     true,
     "2 levels: the next would have more than eight control points for each point"},
    {{FIT, .rounds = 2, .end = BATTEN_LEVELS_NO_GAIN},
     true,
     "2 levels: the last brought the points hardly nearer"},
    {{FIT, .rounds = 2, .end = BATTEN_LEVELS_MOST}, true, "2 levels: not more were allowed"},
    {{FIT, .layered = 0.25, .layers_apart = 8},
     false,
     "25 of 100 points lie beside points that are 8 away in space: the cloud does not lie over its "
     "base once, as a closed body does not, and no surface follows it; divide it, or give another "
     "'base'"},
    {{FIT, .outside = 0.5, .outside_share = 0.11, .outside_at = {7, 8, 9.5}},
     false,
     "the surface leaves the box of the points by 0.5, 0.11 of its size, at (7, 8, 9.5): no points "
     "hold it there"},
    {{FIT, .empty = 1},
     true,
     "1 cell between knots holds no point: there the surface only bends little"},
    {{FIT, .empty = 6},
     true,
     "6 cells between knots hold no point: there the surface only bends little"},
};

static void check_said(const batten_notes *notes, int index, bool is_remark, const char *text)
{
    const batten_note *note = batten_notes_at(notes, index);
    CHECK_TEXT(note->text, text);
    CHECK(note->is_remark == is_remark);
    CHECK_TEXT(note->entity, "near");
    CHECK_INT(note->line, 5);
}

TEST(a_surface_near_points_is_reported_with_all_its_figures)
{
    for (int i = 0; i < COUNT(cases); i++) {
        bat_document document = {.file_name = "a.yaml"};
        bat_result result = {.done = false};
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(4, &notes));
        bat_run run = {.name = "near",
                       .document = &document,
                       .result = &result,
                       .notes = notes,
                       .line = 5};
        bat_report_surface_fit(&run, &cases[i].report);
        CHECK(result.shown.has_error);
        CHECK_BITS(result.shown.error_max, 0.125);
        CHECK_BITS(result.shown.error_rms, 0.0625);
        if (batten_notes_dropped(notes) == 0) {
            CHECK_INT(batten_notes_count(notes), cases[i].more ? 2 : 1);
            check_said(notes, 0, true, SAID);
            if (cases[i].more)
                check_said(notes, 1, cases[i].is_remark, cases[i].more);
        }
        batten_notes_free(notes);
    }
}

TEST(smoothing_has_one_measure)
{
    static const char grid[] =
        "  grid: {points: [[0, 0, 0], [1, 0, 1], [2, 0, 0], [0, 1, 0], [1, 1, 1], [2, 1, 0], [0, "
        "2, 0], [1, 2, 1], [2, 2, 0]], columns: 3}\n";
    static const expect_row rows[] = {
        {"{fit-grid: grid, rms: 0.1, lambda: 1}", BATTEN_BAD_ARGUMENT,
         "give either 'rms' or 'lambda', not both"},
        {"{fit-grid: grid, rms: 0.1}", BATTEN_OK, "notes distance at most 0.141, at (1, 0, 1)"},
        {"{fit-grid: grid, lambda: 1}", BATTEN_OK,
         "notes distance at most 0.66, at (1, 0, 1)"},
        {"{fit-grid: grid, lambda: 0}", BATTEN_OK, "on 0 0 0 0;error 1e-12"},
    };
    EXPECT(grid, rows);
}
