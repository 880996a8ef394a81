#ifndef BATTEN_HULL_H
#define BATTEN_HULL_H
/**
 * @file
 * Hulls: their tables of offsets, the half-breadths and heights at stations, and how they float,
 * at any heel and trim.
 *
 * x runs along the ship, y (half-breadth) to the side, to port, z (height) up.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A table of offsets; immutable, reference counted. */
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
/** What messages call a station. */
typedef struct batten_station_label {
    char text[100];
} batten_station_label;
/**
 * What messages call a station: "station 3 (x = 2)", counted from 1; by the table's own name where
 * that is more than the number x: "station 'stem' (x = 168)". Of long names the first 40 bytes.
 *
 * @param offsets  any table of offsets
 * @param station  which, from 0
 */
BATTEN_API batten_station_label batten_offset_table_label(const batten_offset_table *offsets,
                                                          int station);
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
    int line_count;   /**< keep the points on these lines; 0: on all and on none */
    const char *const *lines; /**< [line_count], names of the table */
} batten_offset_table_selection;
/** The selection that keeps the whole table as it is. */
BATTEN_API batten_offset_table_selection batten_offset_table_everything(void);
/**
 * Stations and lines that are left without points are left out. NOT_FOUND when nothing is
 * left, or the table does not have a line that is named.
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

/* ---- how a hull floats: water is what lies below a plane, and no formula assumes small angles ---- */

/** A hull that is closed and ready to float; immutable. */
typedef struct batten_hull batten_hull;

/** Options of batten_hull_create. */
typedef struct batten_hull_options {
    size_t size; /**< set by batten_hull_defaults */
    /** Each surface is closed by itself, and none is mirrored; else each is mirrored in y = 0,
     * and its edges off that plane are closed by straight lines across to their images. */
    bool whole;
    double
        tolerance; /**< of the NURBS surfaces that stand for others, model units; 0: a millionth
                           of the size */
} batten_hull_options;

/** One half of a hull, tolerance 0. */
static inline batten_hull_options batten_hull_defaults(void)
{
    batten_hull_options options = {sizeof(batten_hull_options), false, 0};
    return options;
}

/** What closes a hull: the lines across from an edge to its image, as a transom or a deck. */
typedef struct batten_hull_lid {
    int surface;                /**< which, counted from 0 */
    batten_direction direction; /**< the parameter that is constant along the edge */
    bool high;                  /**< at the end of its domain */
    batten_box edge;            /**< of the edge itself: of its control points */
    double area;                /**< of the lid, model units squared */
} batten_hull_lid;

/**
 * A hull of surfaces that are one half of it, on either side of y = 0, or the whole; their
 * parameters may run either way. Where both halves are given those with y < 0 must be images of the
 * others, and are left out. The edges of one surface that run along those of another are joints and need no
 * lid; every other edge off the centre plane gets one, see batten_hull_lids.
 *
 * @param count  of surfaces, 1 or more
 * @param surfaces  [count] of 3 dimensions
 * @param options  NULL for the defaults
 * @param[out] out  release with batten_hull_free
 * @return BATTEN_OK; BAD_ARGUMENT (count, options, no extent, a surface across the
 * centre plane or without its image); NOT_COMPATIBLE (surfaces that meet in an edge and face to different
 * sides of it, a whole hull that is not closed); UNSUPPORTED (other
 * dimensions); what batten_surface_to_nurbs returns; OUT_OF_MEMORY
 *
 * Cost: linear in the control points; the edges are compared pairwise.
 */
BATTEN_API batten_status batten_hull_create(int count, const batten_surface *const *surfaces,
                                            const batten_hull_options *options,
                                            batten_hull **out);
/** Release a hull; NULL is welcome. */
BATTEN_API void batten_hull_free(batten_hull *hull);
/** The box of a hull, both sides of it, by its control points. */
BATTEN_API batten_box batten_hull_box(const batten_hull *hull);
/**
 * The lids that close it; borrowed.
 *
 * @param hull  any hull
 * @param[out] count  how many
 */
BATTEN_API const batten_hull_lid *batten_hull_lids(const batten_hull *hull, int *count);

/** How a hull lies in the water, whose surface passes through (0, 0, draught). */
typedef struct batten_flotation {
    double draught; /**< model units */
    double trim;    /**< radians: above 0 the water rises towards lower x, the stern */
    double heel;    /**< radians: above 0 the side of negative y, starboard, goes down */
} batten_flotation;

/** Values of a hull afloat, in the coordinates of the hull. */
typedef struct batten_hydrostatics {
    double volume;         /**< displaced, moulded */
    batten_vec3 buoyancy;  /**< the centre of this volume */
    double waterplane;     /**< its area */
    batten_vec3 flotation; /**< the centre of the waterplane */
    double along;  /**< second moment of the waterplane about its centre, of distances along the
                                 ship: I_L */
    double across; /**< of distances across: I_T */
    double mixed;  /**< of their product */
    double wetted; /**< area of the wet surfaces, without lids */
    double lids;   /**< area of the wet lids */
    double open[2];      /**< area that the wet body lacks to be closed, seen along the ship and
                                 across it; with lids 0 but for rounding */
    double volume_error; /**< estimated, as a share of the volume */
    double area_error;   /**< of the waterplane, as a share of it */
    double wetted_error; /**< of the wetted area, as a share of it */
} batten_hydrostatics;

/**
 * The values of a hull in the water.
 *
 * The wet part of each surface is integrated by Gauss's theorem: with h the height above the
 * water and N du dv the element of area,
 *
 *     V = integral h n.N,  M = integral (P h - n h^2 / 2) n.N,  A = -integral n.N
 *
 * so that nothing is needed of the waterplane itself. Rows of the parameters cross the water at the
 * roots of their polynomials; pieces of polynomial surfaces that are all wet are integrated
 * exactly, others are halved until `precision` is met.
 *
 * @param hull  any hull
 * @param flotation  trim below a right angle, heel below two
 * @param precision  relative, 1e-14 to 0.1
 * @param job  cancelling and the limit of work; NULL for none
 * @param[out] out  the result; all 0 for a hull above the water
 * @return BATTEN_OK; BAD_ARGUMENT; TOLERANCE_NOT_MET; CANCELLED,
 * INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: some 5 m^2 points for each Bezier patch that is wet, m twice its degree; 10 to 30 times that
 * where the waterline turns in one.
 * Source: [RT01] ch. 2; the formulas are Gauss's theorem for fields that vanish on the water.
 */
BATTEN_API batten_status batten_hull_hydrostatics(const batten_hull *hull,
                                                  const batten_flotation *flotation,
                                                  double precision, const batten_job *job,
                                                  batten_hydrostatics *out);

/**
 * How far the waterline reaches: along the ship and across it, in the coordinates of the hull
 * projected on the waterplane.
 *
 * @param hull  any hull
 * @param flotation  as batten_hull_hydrostatics
 * @param tolerance  model units, above 0
 * @param[out] along, across  from where to where; both ends 0 when the hull has no waterline
 * @return BATTEN_OK; BAD_ARGUMENT; TOLERANCE_NOT_MET after 100,000 halvings; OUT_OF_MEMORY
 *
 * Cost: pieces that may reach farthest are halved, some 20 for each end.
 */
BATTEN_API batten_status batten_hull_waterline(const batten_hull *hull,
                                               const batten_flotation *flotation,
                                               double tolerance, batten_interval *along,
                                               batten_interval *across);

/**
 * The wet area of the cross section at a place along the ship, across the x of the hull: a point of
 * the curve of sectional areas for a draught, of Bonjean's curves for a place. Where the hull ends
 * flat, as at a transom, that of the section just inside.
 *
 * @param hull  any hull
 * @param flotation  as batten_hull_hydrostatics
 * @param x  model units; beyond the ends the area is 0
 * @param precision  1e-10 to 0.1, a part of the breadth times the depth of the hull
 * @param job  cancelling and the limit of work; NULL for none
 * @param[out] area  model units squared; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT; TOLERANCE_NOT_MET; CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: some hundred points for each Bezier patch that the section crosses, a few thousand where
 * it leaves the water or turns.
 */
BATTEN_API batten_status batten_hull_section_area(const batten_hull *hull,
                                                  const batten_flotation *flotation, double x,
                                                  double precision, const batten_job *job,
                                                  double *area);

/** What a hull carries, and how it may move. */
typedef struct batten_loading {
    double volume;       /**< to be displaced: the mass over the density */
    batten_vec3 gravity; /**< the centre of the mass */
    bool fixed_heel;     /**< heel stays as it is given */
    bool fixed_trim;     /**< trim stays as it is given */
} batten_loading;

/** A hull at rest. */
typedef struct batten_balance {
    batten_flotation flotation;
    batten_hydrostatics values;
    double
        heeling; /**< the arm that rights it, (B - G) across towards the side that is down: GZ; 0
                            but for rounding where the heel is free */
    double trimming; /**< the same along the ship */
    double metacentric
        [2]; /**< the height of the metacentre above the centre of mass: transverse, longitudinal: GM */
    bool stable; /**< of the free angles: a small turn is righted */
} batten_balance;

/**
 * The draught, and where they are free trim and heel, at which a hull displaces a volume and its
 * centre of buoyancy is plumb below or above its centre of mass.
 *
 * Newton's method with the exact derivatives: of the volume by the waterplane, of the moments by
 * its second moments; steps of at most 5 degrees, the draught by bisection where Newton fails.
 *
 * @param hull  any hull
 * @param loading  what it carries
 * @param start  where to begin; what is fixed is taken from it
 * @param precision  relative, as batten_hull_hydrostatics
 * @param job  as batten_hull_hydrostatics
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT (the volume is not between 0 and that of the hull: it sinks); NOT_FOUND when
 * no equilibrium was found below 80 degrees: it capsizes; TOLERANCE_NOT_MET; as
 * batten_hull_hydrostatics
 *
 * Cost: some 5 to 50 calls of batten_hull_hydrostatics.
 * Source: [RT01] ch. 3 and 4.
 */
BATTEN_API batten_status batten_hull_balance(const batten_hull *hull,
                                             const batten_loading *loading,
                                             const batten_flotation *start, double precision,
                                             const batten_job *job, batten_balance *out);

#ifdef __cplusplus
}
#endif
#endif
