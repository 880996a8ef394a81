#ifndef BATTEN_OFFSET_TABLE_H
#define BATTEN_OFFSET_TABLE_H
/**
 * @file
 * A table of offsets: the half-breadths and heights of a hull at its stations.
 *
 * x runs along the ship, y (half-breadth) to the side, z (height) up. Immutable, reference
 * counted.
 */
#include <batten/geometry.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_offset_table batten_offset_table;

/** A line that runs along the hull through the stations. */
typedef struct batten_table_line {
    const char *name;  /**< "z=0.5", "sheer" */
    bool is_waterline; /**< all its points have the same height */
    double z;          /**< that height; 0 for others */
} batten_table_line;

typedef struct batten_table_point {
    double x; /**< that of the station, or its own where the end of the hull is raked */
    double y; /**< half-breadth, >= 0 as a rule */
    double z; /**< height */
    int line; /**< which line it is on; -1 for none */
} batten_table_point;

/** A section across the hull; its points in order, from the keel up as a rule. */
typedef struct batten_table_station {
    const char *name; /**< as in the table, or its x */
    double x;
    int point_count;
    const batten_table_point *points;
} batten_table_station;

/**
 * A table of offsets. Everything is copied; a name that is NULL becomes "". There is at least
 * one station; stations have increasing x and at least one point each; a point's line must
 * exist.
 *
 * @param unit_metres  how many metres one unit of the numbers is; 0 when the table does not say
 * @param line_count  how many lines, 0 or more
 * @param lines  [line_count], their names and families
 * @param station_count  how many stations, 1 or more
 * @param stations  [station_count], from aft to forward
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: linear in the points.
 */
BATTEN_API batten_status batten_offset_table_create(double unit_metres, int line_count,
                                                    const batten_table_line *lines,
                                                    int station_count,
                                                    const batten_table_station *stations,
                                                    batten_offset_table **out);
/**
 * One more reference to a table, from borrowed to yours.
 *
 * @param offsets  any table of offsets
 */
BATTEN_API batten_offset_table *batten_offset_table_ref(const batten_offset_table *offsets);
/**
 * Give a reference to a table back; NULL is welcome.
 *
 * @param offsets  any table of offsets
 */
BATTEN_API void batten_offset_table_unref(batten_offset_table *offsets);

/**
 * How many metres one unit of the table is; 0 when it does not say.
 *
 * @param offsets  any table of offsets
 */
BATTEN_API double batten_offset_table_unit_metres(const batten_offset_table *offsets);
/**
 * How many lines run along the hull.
 *
 * @param offsets  any table of offsets
 */
BATTEN_API int batten_offset_table_line_count(const batten_offset_table *offsets);
/**
 * The line of this index; borrowed.
 *
 * @param offsets  any table of offsets
 */
BATTEN_API const batten_table_line *batten_offset_table_line(const batten_offset_table *offsets,
                                                             int line);
/**
 * How many stations there are.
 *
 * @param offsets  any table of offsets
 */
BATTEN_API int batten_offset_table_station_count(const batten_offset_table *offsets);
/**
 * The station of this index; borrowed.
 *
 * @param offsets  any table of offsets
 */
BATTEN_API const batten_table_station *
batten_offset_table_station(const batten_offset_table *offsets, int station);
/**
 * The box of all points.
 *
 * @param offsets  any table of offsets
 */
BATTEN_API batten_box batten_offset_table_box(const batten_offset_table *offsets);

/** A part of a table, in other numbers: what a design's `read` can ask for. */
typedef struct batten_offset_table_selection {
    size_t size;
    double scale;       /**< all numbers are multiplied by this; 1 */
    double unit_metres; /**< the unit afterwards; 0 keeps it */
    bool upside_down;   /**< heights were measured downwards: z becomes -z */
    bool reverse;       /**< x becomes -x: the table begins at the bow */
    batten_interval x, y,
        z;            /**< keep the points inside, in the new numbers; infinite by default */
    bool trim_centre; /**< of a run of points on the centre line at the lower end of a station
                           keep only the highest: what is below is keel or air */
} batten_offset_table_selection;
/** The selection that keeps the whole table as it is. */
BATTEN_API batten_offset_table_selection batten_offset_table_everything(void);
/**
 * Stations and lines that are left without points are left out. NOT_FOUND when nothing is
 * left.
 *
 * @param offsets  looked at only
 * @param selection  what is kept, in which numbers; NULL for everything
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_ARGUMENT, NOT_FOUND,
 * OUT_OF_MEMORY
 *
 * Cost: linear in the points.
 */
BATTEN_API batten_status batten_offset_table_select(
    const batten_offset_table *offsets, const batten_offset_table_selection *selection,
    batten_offset_table **out);

#ifdef __cplusplus
}
#endif
#endif
