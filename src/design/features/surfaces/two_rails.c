/* The feature 'two-rails': a section swept along two rails. */
#include "base/plural.h"
#include "design/shared/sweeps.h"

static const batten_parameter parameters[] = {
    {"two-rails", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the rails: the section begins on the first and ends on the second"},
    {"section", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "drawn in the xy-plane; a space curve must have one z at both ends"},
    {"match", BATTEN_VALUE_WORD, false, false, "parameter", "parameter length planes",
     "which points of the rails belong together"},
    {"across", BATTEN_VALUE_POINT, false, false, "x", NULL,
     "with 'planes': at right angles to them; the direction of the rails"},
    {"height", BATTEN_VALUE_WORD, false, false, "scaled", "scaled fixed",
     "of the section, when the distance of the rails changes"},
    BAT_SWEEP_BOUNDS,
};

static batten_status sweep(bat_run *run, const bat_objects *rails)
{
    batten_surface_two_rails_options options = batten_surface_two_rails_defaults();
    const batten_curve *section = NULL;
    batten_surface *surface = NULL;
    batten_surface_sweep_report report;
    if (rails->count != 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "2 rails are needed, not %d", rails->count);
    options.tolerance = bat_sweep_within(run);
    options.degree = bat_count(run, "degree");
    options.match = (batten_rail_match)bat_word(run, "match");
    options.across = bat_point(run, "across");
    options.fixed_height = bat_word(run, "height") == 1;
    batten_status status = bat_one_curve(run, "section", &section);
    if (status == BATTEN_OK)
        status = batten_surface_two_rails(
            section, (const batten_curve *const[2]){rails->at[0]->curve, rails->at[1]->curve},
            &options, run->job, &report, &surface);
    if (status == BATTEN_OK) {
        bat_remark_space_section(run, section);
        bat_report_error(run, report.error, report.error);
        bat_remark(run, "%d section%s", report.section_count, bat_plural(report.section_count));
    }
    return bat_put_surface(run, status, surface);
}

static batten_status run_two_rails(bat_run *run)
{
    bat_objects rails;
    batten_status status = bat_gather(run, "two-rails", BAT_CURVES, &rails);
    if (status != BATTEN_OK)
        return status;
    status = sweep(run, &rails);
    bat_objects_release(&rails);
    return status;
}

const bat_feature bat_feature_two_rails = {
    .shown =
        {"two-rails", "A section swept along two rails",
         "The section is drawn in the xy-plane; its chord is placed between the rails, its y-axis\n"
         "across them; the z of a section that leaves the plane is taken along the rails. As the\n"
         "rails diverge it grows as a whole, or keeps its 'height'. Rails may meet at their ends,\n"
         "but not cross.",
         "units: m\n"
         "features:\n"
         "  left points: {points: [[0, 0, 0], [2, -0.3, 0], [4, 0, 0.5]]}\n"
         "  right points: {points: [[0, 1, 0], [2, 1.6, 0], [4, 1.2, 0.3]]}\n"
         "  left: {interpolate: left points}\n"
         "  right: {interpolate: right points}\n"
         "  bow: {conic: [[0, 0], [0.5, 1], [1, 0]], weight: 1}\n"
         "  roof: {two-rails: [left, right], section: bow}\n",
         "[PT97 section 10.4]", "batten_surface_two_rails", BAT_PARAMETERS(parameters), false,
         .also = "birail, two rails, sweep two, double rail",
         .formula =
             "    S(u, v) = γ1(v) + |γ2(v) − γ1(v)|/|B − A| · F(v) (C(u) − A),  A, B the ends of the section",
         .promise = "Both rails are met within the tolerance."},
    .run = run_two_rails,
    .beside = "section"};
