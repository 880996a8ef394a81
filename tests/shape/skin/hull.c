/* The sections of a cargo ship, written by another program beside the surface that they were
 * cut from. */
#include <batten/exchange.h>
#include <batten/nearest.h>
#include <batten/skin.h>

#include "support/test.h"

enum { SECTIONS = 31, PLACES = 24 };

static const batten_curve *section_of(const batten_model *model, int k)
{
    return batten_model_object(model, k)->curve;
}

/* Points of the sections (`between` 0), or of the surface midway between them from section
 * `first` to `last`, and their largest distance from the reference. */
static double distance_between(const batten_surface *reference, const batten_surface *skin,
                               const double *v, int first, int last)
{
    double *points = test_array(3 * SECTIONS * (PLACES + 1), sizeof *points);
    int count = 0;
    for (int k = first; k < last; k++)
        for (int i = 0; i <= PLACES; i++, count++)
            CHECK_OK(batten_surface_evaluate(skin, (double)i / PLACES, (v[k] + v[k + 1]) / 2, 0,
                                             points + 3 * count));
    batten_deviation found;
    CHECK_OK(batten_surface_deviation(reference, (batten_points){3, count, points}, NULL, NULL,
                                      NULL, &found));
    return found.max;
}

static double distance_of_sections(const batten_surface *reference, const batten_model *model)
{
    double *points = test_array(3 * SECTIONS * (PLACES + 1), sizeof *points);
    int count = 0;
    for (int k = 0; k < SECTIONS; k++) {
        const batten_interval domain = batten_curve_domain(section_of(model, k));
        for (int i = 0; i <= PLACES; i++, count++) {
            const double s = (double)i / PLACES;
            CHECK_OK(batten_curve_evaluate(section_of(model, k),
                                           (1 - s) * domain.a + s * domain.b, 0,
                                           points + 3 * count));
        }
    }
    batten_deviation found;
    CHECK_OK(batten_surface_deviation(reference, (batten_points){3, count, points}, NULL, NULL,
                                      NULL, &found));
    return found.max;
}

/*
 * The sections are chains of Bezier cubics, whose union has 176 inner knots, three times each:
 * 517 x 31 control points, and creases. Matched by arc length at one millimetre 29 x 31 do. The
 * given sections are up to 3.6 mm from the reference themselves. Aft of the last but three the
 * hull changes from a full section to a third of its depth between two sections, which say
 * nothing of how.
 */
TEST(the_sections_of_a_cargo_ship_need_few_control_points_at_a_millimetre)
{
    batten_model *model = NULL, *other = NULL;
    const char *path = test_data("hull_surfaces/cargo_hull_surface.igs");
    if (test_cases(10) < 10)
        return; /* too long to repeat for each allocation */
    CHECK_OK(batten_read_file(path, NULL, NULL, NULL, &other));
    CHECK_OK(batten_read_file(test_data("hull_surfaces/cargo_hull_sections.igs"), NULL, NULL,
                              NULL, &model));
    CHECK_INT(batten_model_count(model), SECTIONS);
    const batten_surface *reference = batten_model_object(other, 0)->surface;
    const batten_curve *sections[SECTIONS];
    for (int k = 0; k < SECTIONS; k++)
        sections[k] = section_of(model, k);
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface_skin_report exact, few;
    batten_surface *heavy = NULL, *light = NULL;
    double v[SECTIONS];
    CHECK_OK(batten_surface_skin((batten_curve_row){SECTIONS, sections}, &options, NULL, NULL,
                                 &exact, &heavy));
    options.tolerance = 1e-3;
    options.match = BATTEN_MATCH_ARC_LENGTH;
    CHECK_OK(batten_surface_skin((batten_curve_row){SECTIONS, sections}, &options, NULL, v,
                                 &few, &light));
    CHECK(exact.crease > 0.01 && few.crease == 0 && few.cure == BATTEN_CURE_STRETCHED);
    CHECK(few.error <= 1e-3 && few.crossing == -1 && few.disorder == -1);
    CHECK(batten_surface_point_count(heavy, BATTEN_U) >=
          10 * batten_surface_point_count(light, BATTEN_U));
    CHECK_INT(batten_surface_point_count(light, BATTEN_V), SECTIONS);
    CHECK_NEAR(distance_of_sections(reference, model), 3.6e-3, 1e-4);
    CHECK(distance_between(reference, light, v, 0, 26) < 4e-3);
    CHECK(distance_between(reference, light, v, 26, 28) < 10e-3);
    batten_surface_unref(light);
    batten_surface_unref(heavy);
    batten_model_unref(other);
    batten_model_unref(model);
}
