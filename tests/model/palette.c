/* The colours of triangles, each once. */
#include "model/palette.h"
#include "support/test.h"

static const double colours[] = {0.5, 0, 0,   0,   0,   1, 0.5, 0, 0,
                                 0,   0, 0.5, 0.5, 0.5, 0, 0,   0, 1};

/* Rising by red, then green, then blue; triangles of one colour as they come. */
TEST(triangles_are_sorted_by_their_colour_and_then_as_they_come)
{
    static const int first[] = {0, 1, 3, 5, 6}, order[] = {3, 1, 5, 0, 2, 4};
    static const int of[] = {2, 1, 2, 0, 3, 1};
    const batten_mesh_parts parts = {.triangle_count = 6, .triangle_colours = colours};
    bat_palette palette;
    CHECK_OK(bat_palette_find(&parts, &palette));
    CHECK_INT(palette.count, 4);
    for (int i = 0; i <= 4; i++)
        CHECK_INT(palette.first[i], first[i]);
    for (int i = 0; i < 6; i++) {
        CHECK_INT(palette.order[i], order[i]);
        CHECK_INT(palette.of[i], of[i]);
    }
    for (int i = 0; i < 4; i++)
        CHECK(memcmp(bat_palette_colour(&palette, &parts, i), colours + 3 * order[first[i]],
                     3 * sizeof(double)) == 0);
    bat_palette_end(&palette);
    CHECK(palette.first == NULL && palette.count == 0);
}

TEST(many_colours_are_as_many_and_one_is_one)
{
    enum { MANY = 300 };
    double each[3 * MANY], same[3 * MANY];
    bat_palette palette;
    for (int i = 0; i < 3 * MANY; i++) {
        each[i] = (i * 7 % MANY) / (double)MANY;
        same[i] = 0.25;
    }
    CHECK_OK(bat_palette_find(
        &(batten_mesh_parts){.triangle_count = MANY, .triangle_colours = each}, &palette));
    CHECK_INT(palette.count, MANY / 3); /* 21 i mod 300 has a hundred values */
    for (int i = 0; i < MANY; i++) {
        const int colour = palette.of[palette.order[i]];
        CHECK(i >= palette.first[colour] && i < palette.first[colour + 1]);
    }
    bat_palette_end(&palette);
    CHECK_OK(bat_palette_find(
        &(batten_mesh_parts){.triangle_count = MANY, .triangle_colours = same}, &palette));
    CHECK_INT(palette.count, 1);
    CHECK_INT(palette.first[1], MANY);
    for (int i = 0; i < MANY; i++)
        CHECK_INT(palette.order[i], i);
    bat_palette_end(&palette);
}
