#include "picture/sheet/view.h"

#include "picture/scenes.h"

TEST(every_view_is_three_unit_vectors_at_right_angles)
{
    for (int view = BATTEN_VIEW_AUTO; view <= BATTEN_VIEW_AXONOMETRIC; view++)
        for (int k = 0; k < 10; k++) {
            const bat_view v = bat_view_make(view, 0.7 * k, 0.4 * k - 1.5);
            CHECK_NEAR(bat_dot(3, v.right, v.right), 1, 1e-15);
            CHECK_NEAR(bat_dot(3, v.up, v.up), 1, 1e-15);
            CHECK_NEAR(bat_dot(3, v.right, v.up), 0, 1e-15);
            /* right x up = eye */
            CHECK_NEAR(v.right[1] * v.up[2] - v.right[2] * v.up[1], v.eye[0], 1e-15);
            CHECK_NEAR(v.right[2] * v.up[0] - v.right[0] * v.up[2], v.eye[1], 1e-15);
            CHECK_NEAR(v.right[0] * v.up[1] - v.right[1] * v.up[0], v.eye[2], 1e-15);
        }
}

TEST(the_plane_views_show_the_axes_that_they_promise)
{
    static const struct {
        batten_view view;
        int right, up;
    } rows[] = {{BATTEN_VIEW_TOP, 0, 1}, {BATTEN_VIEW_FRONT, 1, 2}, {BATTEN_VIEW_SIDE, 0, 2}};
    for (int i = 0; i < COUNT(rows); i++) {
        const bat_view v = bat_view_make(rows[i].view, 1, 1);
        const double point[] = {3, 5, 7};
        double seen[3];
        bat_view_project(&v, point, seen);
        CHECK_BITS(seen[0], point[rows[i].right]);
        CHECK_BITS(seen[1], point[rows[i].up]);
    }
}

TEST(the_isometric_view_shortens_all_axes_alike)
{
    const bat_view v = bat_view_make(BATTEN_VIEW_AXONOMETRIC, atan(1), atan(sqrt(0.5)));
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(hypot(v.right[k], v.up[k]), sqrt(2.0 / 3), 1e-15);
    CHECK(v.up[2] > 0);
}
