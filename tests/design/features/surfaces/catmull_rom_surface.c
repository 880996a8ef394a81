/* 'catmull-rom-surface': degrees, closing and the error of the local surface through a grid. */
#include "design/evaluate.h"

#include <batten/nearest.h>

/* Four rows of four points over 0 .. 3, with heights that no plane has. */
static const double heights[4][4] = {{0, 1, 0, 2}, {1, 3, -1, 0}, {0, 1, 2, 1}, {2, 0, 1, 0}};

static void write_design(const char *options, size_t size, char *text)
{
    int used = snprintf(text, size, "batten: 1\nfeatures:\n  net: {points: [");
    for (int i = 0; i < 16; i++)
        used += snprintf(text + used, size - (size_t)used, "%s[%d, %d, %g]", i ? ", " : "",
                         i % 4, i / 4, heights[i / 4][i % 4]);
    snprintf(text + used, size - (size_t)used,
             "], columns: 4}\n  a: {catmull-rom-surface: net%s}\n", options);
}

static const struct {
    const char *options;
    int degree;
    bool closed[2], passes;
} rows[] = {
    {"", 3, {false, false}, true},
    {", blend: 3, local: 2", 5, {false, false}, true},
    {", blend: 1, local: 1", 2, {false, false}, true},
    {", blend: 3, local: 1", 4, {false, false}, false},
    {", closed-u: yes", 3, {true, false}, true},
    {", closed-v: yes", 3, {false, true}, true},
    {", closed-u: yes, closed-v: yes, blend: 3, local: 2", 5, {true, true}, true},
};

static double distance_from(const batten_surface *surface, const double point[3])
{
    batten_deviation found;
    CHECK_OK(batten_surface_deviation(surface, (batten_points){3, 1, point}, NULL, NULL, NULL,
                                      &found));
    return found.max;
}

TEST(the_local_surface_has_the_degrees_closes_as_asked_and_passes_the_points_where_it_can)
{
    for (int i = 0; i < COUNT(rows); i++) {
        char text[1000];
        batten_design *design = NULL;
        write_design(rows[i].options, sizeof text, text);
        CHECK_OK(evaluate_design(text, "a", NULL, &design));
        const batten_model *made = batten_design_result(design, "a")->value;
        const batten_surface *surface = batten_model_object(made, 0)->surface;
        for (int k = 0; k < 2; k++) {
            const batten_direction d = k ? BATTEN_V : BATTEN_U;
            CHECK_INT(batten_surface_degree(surface, d), rows[i].degree);
            CHECK_INT(batten_surface_is_closed(surface, d, 1e-9), rows[i].closed[k]);
        }
        double worst = 0;
        for (int k = 0; k < 16; k++) {
            const double point[3] = {k % 4, k / 4, heights[k / 4][k % 4]};
            worst = fmax(worst, distance_from(surface, point));
        }
        CHECK_INT(worst < 1e-6, rows[i].passes);
        batten_design_free(design);
    }
}
