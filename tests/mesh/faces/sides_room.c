/* The triangles that sides are put into: all of the hull, however thin. */
#include "mesh/faces/sides.h"
#include "support/test.h"

/* Four points, one of them this far below the side between two others: two triangles, of which one is thin. */
TEST(thin_triangles_at_the_rim_are_kept)
{
    static const double heights[] = {1, 1e-3, 1e-6, 1e-9};
    for (int i = 0; i < COUNT(heights); i++) {
        const double points[4][2] = {{0, 0}, {1, -heights[i]}, {2, 0}, {1, 1}};
        bat_sides s;
        int vertex_of[4];
        CHECK_OK(bat_sides_begin(&s, 4, points, vertex_of));
        CHECK_INT(s.count, 2);
        CHECK_INT(s.vertex_count, 4);
        for (int k = 0; k < 4; k++)
            for (int c = 0; c < 2; c++)
                CHECK_NEAR(s.at[vertex_of[k]][c], points[k][c], 0);
        bat_sides_end(&s);
    }
}
