/* Which parts of a sheet are covered by lines: a grid of cells. */
#include "picture/sheet/cover.h"

batten_status bat_cover_make(double width, double height, double cell, bat_cover *out)
{
    /* At most 2,000 x 2,000 cells, whatever the letters. */
    const double side = bat_max(cell, bat_max(width, height) / 2000);
    bat_cover cover = {
        .cell = side, .columns = (int)(width / side) + 1, .rows = (int)(height / side) + 1};
    cover.cells = bat_array3((size_t)cover.columns, (size_t)cover.rows, sizeof *cover.cells);
    if (!cover.cells)
        return BATTEN_OUT_OF_MEMORY;
    *out = cover;
    return BATTEN_OK;
}

void bat_cover_free(bat_cover *cover)
{
    bat_release(cover->cells);
}

/* The cells that a box meets: first and last column, first and last row. */
static void cells_of(const bat_cover *cover, const double box[4], int out[4])
{
    const int most[2] = {cover->columns - 1, cover->rows - 1};
    for (int k = 0; k < 4; k++) {
        const double at = bat_max(0, bat_min(floor(box[k] / cover->cell), most[k % 2]));
        out[k] = (int)at;
    }
}

static void mark(bat_cover *cover, double x, double y, double half)
{
    int at[4];
    cells_of(cover, (double[4]){x - half, y - half, x + half, y + half}, at);
    for (int row = at[1]; row <= at[3]; row++)
        for (int column = at[0]; column <= at[2]; column++)
            cover->cells[(size_t)row * (size_t)cover->columns + (size_t)column] = 1;
}

/* The part of the segment inside the box, from share[0] to share[1] of its length; false when
 * there is none. */
static bool clip(const double a[2], const double b[2], const double box[4], double share[2])
{
    share[0] = 0, share[1] = 1;
    for (int k = 0; k < 2; k++) {
        const double along = b[k] - a[k], low = box[k] - a[k], high = box[k + 2] - a[k];
        if (!(along != 0)) {
            if (!(low <= 0 && high >= 0))
                return false;
            continue;
        }
        const double enter = (along > 0 ? low : high) / along;
        const double leave = (along > 0 ? high : low) / along;
        share[0] = bat_max(share[0], enter);
        share[1] = bat_min(share[1], leave);
    }
    return share[0] <= share[1];
}

void bat_cover_segment(bat_cover *cover, const double a[2], const double b[2], double half,
                       const double box[4])
{
    double share[2];
    if (!isfinite(a[0] + a[1] + b[0] + b[1]) || !clip(a, b, box, share))
        return;
    const double x = b[0] - a[0], y = b[1] - a[1];
    const double length = (share[1] - share[0]) * bat_hypot(x, y);
    /* Steps of a quarter of a cell miss no more than the corner that bat_cover_is_free adds. */
    const int steps = (int)(4 * length / cover->cell) + 1;
    for (int i = 0; i <= steps; i++) {
        const double t = share[0] + (share[1] - share[0]) * i / steps;
        mark(cover, a[0] + t * x, a[1] + t * y, half);
    }
}

bool bat_cover_is_free(const bat_cover *cover, const double box[4])
{
    int at[4];
    const double corner = 0.25 * cover->cell;
    cells_of(cover,
             (double[4]){box[0] - corner, box[1] - corner, box[2] + corner, box[3] + corner},
             at);
    for (int row = at[1]; row <= at[3]; row++)
        for (int column = at[0]; column <= at[2]; column++)
            if (cover->cells[(size_t)row * (size_t)cover->columns + (size_t)column])
                return false;
    return true;
}
