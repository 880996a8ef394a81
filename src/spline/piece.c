/* One span of a spline in Bezier form: how curves and surfaces are evaluated. */
#include "spline/spline.h"

const double bat_binomials[BATTEN_MAX_DEGREE + 1][BATTEN_MAX_DEGREE + 1] = {
    {1},
    {1, 1},
    {1, 2, 1},
    {1, 3, 3, 1},
    {1, 4, 6, 4, 1},
    {1, 5, 10, 10, 5, 1},
    {1, 6, 15, 20, 15, 6, 1},
    {1, 7, 21, 35, 35, 21, 7, 1},
    {1, 8, 28, 56, 70, 56, 28, 8, 1},
    {1, 9, 36, 84, 126, 126, 84, 36, 9, 1},
    {1, 10, 45, 120, 210, 252, 210, 120, 45, 10, 1},
    {1, 11, 55, 165, 330, 462, 462, 330, 165, 55, 11, 1},
    {1, 12, 66, 220, 495, 792, 924, 792, 495, 220, 66, 12, 1},
    {1, 13, 78, 286, 715, 1287, 1716, 1716, 1287, 715, 286, 78, 13, 1},
    {1, 14, 91, 364, 1001, 2002, 3003, 3432, 3003, 2002, 1001, 364, 91, 14, 1},
    {1, 15, 105, 455, 1365, 3003, 5005, 6435, 6435, 5005, 3003, 1365, 455, 105, 15, 1},
    {1, 16, 120, 560, 1820, 4368, 8008, 11440, 12870, 11440, 8008, 4368, 1820, 560, 120, 16, 1},
    {1, 17, 136, 680, 2380, 6188, 12376, 19448, 24310, 24310, 19448, 12376, 6188, 2380, 680,
     136, 17, 1},
    {1, 18, 153, 816, 3060, 8568, 18564, 31824, 43758, 48620, 43758, 31824, 18564, 8568, 3060,
     816, 153, 18, 1},
    {1,     19,    171,   969,   3876,  11628, 27132, 50388, 75582, 92378,
     92378, 75582, 50388, 27132, 11628, 3876,  969,   171,   19,    1},
    {1,      20,     190,   1140,  4845,  15504, 38760, 77520, 125970, 167960, 184756,
     167960, 125970, 77520, 38760, 15504, 4845,  1140,  190,   20,     1},
    {1,      21,     210,    1330,   5985,  20349, 54264, 116280, 203490, 293930, 352716,
     352716, 293930, 203490, 116280, 54264, 20349, 5985,  1330,   210,    21,     1},
    {1,      22,     231,    1540,   7315,   26334,  74613,  170544,
     319770, 497420, 646646, 705432, 646646, 497420, 319770, 170544,
     74613,  26334,  7315,   1540,   231,    22,     1},
    {1,      23,     253,     1771,    8855,    33649,   100947, 245157,
     490314, 817190, 1144066, 1352078, 1352078, 1144066, 817190, 490314,
     245157, 100947, 33649,   8855,    1771,    253,     23,     1},
    {1,       24,      276,     2024,    10626,   42504,   134596,  346104, 735471,
     1307504, 1961256, 2496144, 2704156, 2496144, 1961256, 1307504, 735471, 346104,
     134596,  42504,   10626,   2024,    276,     24,      1},
    {1,       25,      300,     2300,    12650,   53130,   177100,  480700,  1081575,
     2042975, 3268760, 4457400, 5200300, 5200300, 4457400, 3268760, 2042975, 1081575,
     480700,  177100,  53130,   12650,   2300,    300,     25,      1},
};

/* row = (1 - alpha) row + alpha other */
static void blend(size_t width, double *row, double alpha, const double *other)
{
    const double beta = 1 - alpha;
    for (size_t c = 0; c < width; c++)
        row[c] = beta * row[c] + alpha * other[c];
}

void bat_piece_from_rows(int degree, const double *knots, int span, size_t width, double *rows)
{
    const int p = degree;
    const double *U = knots + span;
    const double a = U[0], b = U[1];
    /* a is inserted until row j is the blossom at (a .., U[1] .. U[j]) ... */
    for (int r = 1; r <= p; r++)
        for (int j = 0; j <= p - r; j++) {
            const double left = U[r + j - p], right = U[j + 1];
            if (left != a)
                blend(width, rows + (size_t)j * width, (a - left) / (right - left),
                      rows + (size_t)(j + 1) * width);
        }
    /* ... and b until it is the blossom at (a .., b ..): the Bezier point j. */
    for (int r = 1; r < p; r++)
        for (int j = p; j > r; j--) {
            const double right = U[j - r + 1];
            if (right != b)
                blend(width, rows + (size_t)j * width, (right - b) / (right - a),
                      rows + (size_t)(j - 1) * width);
        }
}

void bat_piece_derive(int degree, double width_of_span, size_t width, double *rows)
{
    const double factor = degree / width_of_span;
    for (size_t i = 0; i < (size_t)degree * width; i++)
        rows[i] = (rows[i + width] - rows[i]) * factor;
}

void bat_rows_derive(int degree, const double *knots, int span, size_t width, double *rows)
{
    const int p = degree;
    for (int j = 0; j < p; j++) {
        const double factor = p / (knots[span + 1 + j] - knots[span + 1 + j - p]);
        for (size_t c = 0; c < width; c++) {
            const size_t i = (size_t)j * width + c;
            rows[i] = (rows[i + width] - rows[i]) * factor;
        }
    }
}

bool bat_span_is_tight(int degree, const double *knots, int span)
{
    const double h = knots[span + 1] - knots[span];
    for (int j = 0; j < degree; j++)
        if (knots[span + 1 + j] - knots[span + 1 + j - degree] > 64 * degree * h)
            return true;
    return false;
}

void bat_bernstein(int degree, double t, double s, double *out)
{
    double power = 1;
    for (int i = 0; i <= degree; i++, power *= t)
        out[i] = bat_binomials[degree][i] * power;
    power = s;
    for (int i = degree - 1; i >= 0; i--, power *= s)
        out[i] *= power;
}

void bat_combine(int degree, const double *basis, size_t width, const double *rows, double *out)
{
    for (size_t c = 0; c < width; c++) {
        double sum = basis[0] * rows[c];
        for (int i = 1; i <= degree; i++)
            sum += basis[i] * rows[(size_t)i * width + c];
        out[c] = sum;
    }
}
