/* The table of the 255 numbered colours, and colours of 24 bits. */
#include "exchange/dxf/colours.h"
#include "numeric/vector.h"

/* The hue in steps of 15 degrees as red, green and blue from 0 to 1. */
static void hue(int step, double rgb[3])
{
    const double h = step / 4.0; /* in sixths of the circle */
    const double red = bat_min(1, bat_max(0, fabs(h - 3) - 1));
    const double green = bat_min(1, bat_max(0, 2 - fabs(h - 2)));
    const double blue = bat_min(1, bat_max(0, 2 - fabs(h - 4)));
    rgb[0] = red;
    rgb[1] = green;
    rgb[2] = blue;
}

bool bat_dxf_colour(int index, double rgb[3])
{
    static const double basic[10][3] = {{0, 0, 0},    {1, 0, 0},      {1, 1, 0}, {0, 1, 0},
                                        {0, 1, 1},    {0, 0, 1},      {1, 0, 1}, {0, 0, 0},
                                        {.5, .5, .5}, {.75, .75, .75}};
    static const double greys[6] = {0.2, 0.31, 0.41, 0.51, 0.75, 1};
    static const double values[5] = {1, 0.65, 0.5, 0.3, 0.15};
    if (index < 1 || index > 255)
        return false;
    for (int k = 0; k < 3; k++)
        rgb[k] = index < 10 ? basic[index][k] : index >= 250 ? greys[index - 250] : 0;
    if (index < 10 || index >= 250)
        return true;
    hue((index - 10) / 10, rgb);
    const double value = values[index % 10 / 2];
    for (int k = 0; k < 3; k++) /* odd numbers are half as strong */
        rgb[k] = value * (index % 2 ? (1 + rgb[k]) / 2 : rgb[k]);
    return true;
}

void bat_dxf_true_colour(int value, double rgb[3])
{
    for (int k = 0; k < 3; k++)
        rgb[k] = ((value >> (16 - 8 * k)) & 255) / 255.0;
}

bat_dxf_colour_code bat_dxf_code_of_colour(const double rgb[3])
{
    bat_dxf_colour_code code = {BAT_DXF_PLAIN, 0};
    double least = INFINITY;
    for (int i = 1; i < 256; i++) {
        double candidate[3];
        bat_dxf_colour(i, candidate);
        const double distance = bat_distance(3, rgb, candidate);
        if (distance < least) {
            least = distance;
            code.index = i;
        }
    }
    for (int k = 0; k < 3; k++)
        code.full = code.full << 8 | (int)(255 * bat_min(1, bat_max(0, rgb[k])) + 0.5);
    /* Parts of a colour are multiples of 1/255: what is this near is the same. */
    if (least < 1e-6 && code.index != BAT_DXF_PLAIN)
        code.full = -1;
    return code;
}
