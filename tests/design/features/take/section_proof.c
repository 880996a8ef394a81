/* How many lines a section can have is proved by the control net, and nothing else is. */
#include "design/features/take/section_proof.h"
#include "support/test.h"

/* Degree 1 by 2 on 2 x 5 points with x rising along u, and these heights of both rows. */
static batten_surface *strip(const double low[5], const double high[5], const double *weights)
{
    static const double ku[] = {0, 0, 1, 1}, kv[] = {0, 0, 0, 1, 2, 3, 3, 3};
    const batten_axis u = {1, 2, ku, false}, v = {2, 5, kv, false};
    double points[2 * 5 * 3];
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 5; k++) {
            double *p = points + 3 * (5 * i + k);
            p[0] = i;
            p[1] = k;
            p[2] = (i ? high : low)[k];
        }
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, weights, &surface));
    return surface;
}

static const double below[5] = {-1, -1, -1, -1, -1}, above[5] = {1, 1, 1, 1, 1};
static const double wavy[5] = {1, -0.5, -0.5, 1, 2}, dip[5] = {-1, -1, 0.5, -1, -1};
static const double touching[5] = {1, 0, 0, 1, 1};

/* Heights of both rows, and how many lines prove the section at height 0: -1 for none. */
static const struct {
    const double *low, *high;
    int lines;
} rows[] = {{below, above, 1},     /* across */
            {above, below, 1},     /* falling */
            {below, wavy, 2},      /* two parts at most */
            {dip, above, 2},       /* parted by a hill of the lower edge */
            {below, touching, -1}, /* an edge in the plane for all that is known */
            {below, below, 0},     /* all below */
            {above, above, 0},     /* all above */
            {wavy, dip, -1}};      /* neither rises nor falls everywhere */

TEST(as_many_lines_as_there_can_be_are_all)
{
    static const double weights[10] = {1, 2, 1, 3, 1, 1, 1, 1.5, 1, 2};
    for (int i = 0; i < COUNT(rows); i++)
        for (int k = 0; k < 2; k++) {
            batten_surface *s = strip(rows[i].low, rows[i].high, k ? weights : NULL);
            for (int lines = 0; lines < 4; lines++)
                CHECK_INT(bat_section_is_proved(s, 2, 0, lines), lines == rows[i].lines);
            batten_surface_unref(s);
        }
}

TEST(each_coordinate_and_either_direction_proves)
{
    batten_surface *s = strip(below, above, NULL);
    CHECK(bat_section_is_proved(s, 0, 0.25, 1));
    CHECK(bat_section_is_proved(s, 1, 2.5, 1));
    CHECK(bat_section_is_proved(s, 0, 7, 0) && !bat_section_is_proved(s, 0, 7, 1));
    CHECK(!bat_section_is_proved(s, 0, 1, 1)); /* along its edge */
    CHECK(!bat_section_is_proved(s, 0, 1, 0));
    batten_surface_unref(s);
}
