/* The numbered colours of the format, as published, of 255. */
#include "exchange/dxf/colours.h"
#include "support/test.h"

static const struct {
    int index, red, green, blue;
} published[] = {
    {1, 255, 0, 0},       {2, 255, 255, 0},     {3, 0, 255, 0},       {4, 0, 255, 255},
    {5, 0, 0, 255},       {6, 255, 0, 255},     {10, 255, 0, 0},      {11, 255, 127, 127},
    {12, 165, 0, 0},      {13, 165, 82, 82},    {14, 127, 0, 0},      {15, 127, 63, 63},
    {16, 76, 0, 0},       {17, 76, 38, 38},     {18, 38, 0, 0},       {19, 38, 19, 19},
    {20, 255, 63, 0},     {30, 255, 127, 0},    {40, 255, 191, 0},    {50, 255, 255, 0},
    {60, 191, 255, 0},    {70, 127, 255, 0},    {80, 63, 255, 0},     {90, 0, 255, 0},
    {100, 0, 255, 63},    {110, 0, 255, 127},   {120, 0, 255, 191},   {130, 0, 255, 255},
    {140, 0, 191, 255},   {150, 0, 127, 255},   {160, 0, 63, 255},    {170, 0, 0, 255},
    {180, 63, 0, 255},    {190, 127, 0, 255},   {200, 191, 0, 255},   {210, 255, 0, 255},
    {220, 255, 0, 191},   {230, 255, 0, 127},   {240, 255, 0, 63},    {249, 38, 19, 23},
    {250, 51, 51, 51},    {251, 80, 80, 80},    {252, 105, 105, 105}, {253, 130, 130, 130},
    {254, 190, 190, 190}, {255, 255, 255, 255},
};

/* Published values are whole numbers of 255, some of them rounded down; greys are hundredths. */
TEST(numbered_colours_are_those_that_are_published)
{
    for (int i = 0; i < COUNT(published); i++) {
        double rgb[3];
        CHECK(bat_dxf_colour(published[i].index, rgb));
        CHECK_NEAR(255 * rgb[0], published[i].red, 1.3);
        CHECK_NEAR(255 * rgb[1], published[i].green, 1.3);
        CHECK_NEAR(255 * rgb[2], published[i].blue, 1.3);
    }
}

TEST(colours_have_numbers_from_1_to_255)
{
    double rgb[3];
    CHECK(!bat_dxf_colour(0, rgb) && !bat_dxf_colour(256, rgb) && !bat_dxf_colour(-1, rgb));
}

/* Red above green above blue; what is outside of 0 to 1 is cut. */
TEST(a_colour_of_24_bits_has_red_first)
{
    double rgb[3];
    bat_dxf_true_colour(0x3366cc, rgb);
    CHECK_BITS(rgb[0], 0x33 / 255.0);
    CHECK_BITS(rgb[1], 0x66 / 255.0);
    CHECK_BITS(rgb[2], 0xcc / 255.0);
    CHECK_INT(bat_dxf_code_of_colour(rgb).full, 0x3366cc);
    CHECK_INT(bat_dxf_code_of_colour((double[]){-1, 2, 0.1}).full, 0x00ff1a);
}

/* The first of equal ones; black and white have a number that means neither, so 24 bits too. */
TEST(a_colour_has_the_number_of_the_nearest_and_24_bits_where_it_is_another)
{
    const bat_dxf_colour_code red = bat_dxf_code_of_colour((double[]){1, 0, 0});
    const bat_dxf_colour_code near = bat_dxf_code_of_colour((double[]){0.98, 0.02, 0});
    const bat_dxf_colour_code black = bat_dxf_code_of_colour((double[]){0, 0, 0});
    CHECK_INT(red.index, 1);
    CHECK_INT(red.full, -1);
    CHECK_INT(near.index, 1);
    CHECK_INT(near.full, 0xfa0500);
    CHECK_INT(black.index, BAT_DXF_PLAIN);
    CHECK_INT(black.full, 0);
}
