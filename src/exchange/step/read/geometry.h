/* What the files that read geometry share. */
#ifndef BAT_STEP_GEOMETRY_H
#define BAT_STEP_GEOMETRY_H
#include "exchange/step/read/shapes.h"

/* How geometry is read: in space, or in the parameters of a surface, where the unit of length
 * is 1 and there are 2 coordinates. */
typedef struct bat_step_reading bat_step_reading;

/* Who makes a curve or surface of any kind, for those that stand on others. Only shapes.c knows
 * all kinds, and hands this in. */
typedef struct {
    batten_status (*curve)(const bat_step_reading *, const bat_step_instance *,
                           batten_curve **);
    batten_status (*surface)(const bat_step_reading *, const bat_step_instance *,
                             batten_surface **);
} bat_step_makers;

struct bat_step_reading {
    const bat_step_file *file;
    bat_step_scale scale;
    int dimension;
    int depth;                  /* of instances that stand on one another */
    const bat_step_makers *any; /* NULL where only points and directions are read */
};

bat_step_reading bat_step_reading_of(const bat_step_file *file, const bat_step_scale *scale);
/* One deeper; BAD_FORMAT for the instance when that is too deep, or a ring. */
batten_status bat_step_deeper(const bat_step_reading *reading,
                              const bat_step_instance *instance, bat_step_reading *inner);
/* Name the instance in the message of a failure that names none. */
batten_status bat_step_blame(const bat_step_file *file, const bat_step_instance *instance,
                             batten_status status);
/* Has the record so many arguments, the first of them a name? BAD_FORMAT else. */
batten_status bat_step_check_arguments(const bat_step_file *file, const bat_step_record *record,
                                       int count);

/* The record of a keyword of what argument k refers to; BAD_FORMAT, naming both, for others. */
batten_status bat_step_get_record(const bat_step_file *file, const bat_step_record *record,
                                  int k, const char *keyword, const bat_step_record **out);

/* ---- points and directions (points.c) ---- */

/* The third coordinate is 0 in the parameters of a surface. */
batten_status bat_step_point_in(const bat_step_reading *reading,
                                const bat_step_instance *instance, double point[3]);
/* A list of references to points, at *at, which moves behind it, into points[dimension] each.
 */
batten_status bat_step_points_in(const bat_step_reading *reading, const bat_step_record *record,
                                 size_t *at, int count, double *points);
batten_status bat_step_direction_in(const bat_step_reading *reading,
                                    const bat_step_instance *instance, batten_vec3 *direction);
/* A VECTOR, in units of length. */
batten_status bat_step_vector_in(const bat_step_reading *reading,
                                 const bat_step_instance *instance, batten_vec3 *vector);
/* AXIS1_PLACEMENT, AXIS2_PLACEMENT_3D or _2D; unit vectors at right angles. */
batten_status bat_step_frame_in(const bat_step_reading *reading,
                                const bat_step_instance *instance, batten_frame *frame);

/* ---- B-splines (splines.c): *is_spline is false for others ---- */

batten_status bat_step_spline_curve(const bat_step_reading *reading,
                                    const bat_step_instance *instance, batten_curve **out,
                                    bool *is_spline);
bool bat_step_is_spline_surface(const bat_step_file *file, const bat_step_instance *instance);
batten_status bat_step_spline_surface(const bat_step_reading *reading,
                                      const bat_step_instance *instance, batten_surface **out,
                                      bool *is_spline);

/* ---- lines and conics (conics.c) ---- */

batten_status bat_step_conic_in(const bat_step_reading *reading,
                                const bat_step_instance *instance, bat_conic *conic,
                                bool *is_conic);
/* A parameter of the file as one of the conic: an angle for ellipses, in radians. */
double bat_step_conic_parameter(const bat_step_reading *reading, const bat_conic *conic,
                                double t);
/* From parameter t0 to t1 of the conic, with rising t when `forward`. */
batten_status bat_step_conic_part(const bat_step_reading *reading,
                                  const bat_step_instance *instance, const bat_conic *conic,
                                  double t0, double t1, bool forward, batten_curve **out);
/* An ellipse; NOT_COMPATIBLE for those without ends. */
batten_status bat_step_whole_conic(const bat_step_reading *reading,
                                   const bat_step_instance *instance, const bat_conic *conic,
                                   batten_curve **out);

/* ---- curves (surface_curve.c, curves.c, curve_parts.c, composite.c) ---- */

/* A SURFACE_CURVE stands for its 3-D curve, which may be one again. */
batten_status bat_step_resolve(const bat_step_reading *reading,
                               const bat_step_instance **instance);
/* A curve of any kind that another one, or a surface, stands on. */
static inline batten_status bat_step_curve_in(const bat_step_reading *reading,
                                              const bat_step_instance *instance,
                                              batten_curve **out)
{
    return reading->any->curve(reading, instance, out);
}
/* The curve in the parameters of a surface; see bat_step_read_pcurve. */
batten_status bat_step_pcurve_in(const bat_step_reading *reading,
                                 const bat_step_instance *instance,
                                 const bat_step_instance *surface, batten_curve **out);
batten_status bat_step_polyline(const bat_step_reading *reading,
                                const bat_step_instance *instance,
                                const bat_step_record *record, batten_curve **out);
batten_status bat_step_offset_curve(const bat_step_reading *reading,
                                    const bat_step_instance *instance,
                                    const bat_step_record *record, batten_curve **out);
/* Where a PCURVE names its surface, and behind that its curve: in complex instances the name stands in
 * REPRESENTATION_ITEM. */
int bat_step_pcurve_surface(const bat_step_file *file, const bat_step_record *pcurve);
/* The list of what lies on a SURFACE_CURVE, SEAM_CURVE or INTERSECTION_CURVE, and the record for messages; none for other
 * instances. */
batten_status bat_step_pcurves_of(const bat_step_file *file,
                                  const bat_step_instance *surface_curve, int *count,
                                  size_t *first, const bat_step_record **record);
/* A PCURVE as a curve in space. */
batten_status bat_step_curve_on_surface(const bat_step_reading *reading,
                                        const bat_step_instance *instance,
                                        const bat_step_record *record, batten_curve **out);
/* The part between two parameters of the file, running with the parameter when `forward`; of
 * closed curves also over their ends. */
batten_status bat_step_curve_between(const bat_step_reading *reading,
                                     const bat_step_instance *instance, double t0, double t1,
                                     bool forward, batten_curve **out);
/* TRIMMED_CURVE(name, basis, (end), (end), sense, what counts) */
batten_status bat_step_trimmed(const bat_step_reading *reading,
                               const bat_step_instance *instance, const bat_step_record *record,
                               batten_curve **out);
batten_status bat_step_composite(const bat_step_reading *reading,
                                 const bat_step_instance *instance,
                                 const bat_step_record *record, batten_curve **out);

/* ---- surfaces (surfaces.c, trimmed_surface.c) ---- */

/* Planes, cylinders, cones, spheres, tori. */
batten_status bat_step_primitive_in(const bat_step_reading *reading,
                                    const bat_step_instance *instance,
                                    bat_elementary *elementary, bool *is_primitive);
/* A curve along z of the frame, as long as that, or turned about it. */
typedef struct {
    bool turned;
    const bat_step_instance *curve;
    batten_frame frame;
} bat_step_sweep;
batten_status bat_step_sweep_in(const bat_step_reading *reading,
                                const bat_step_instance *instance, bat_step_sweep *sweep,
                                bool *is_sweep);
batten_status bat_step_elementary_in(const bat_step_reading *reading,
                                     const bat_step_instance *instance,
                                     bat_elementary *elementary, bat_step_basis *basis,
                                     bool *is_elementary);
static inline batten_status bat_step_surface_in(const bat_step_reading *reading,
                                                const bat_step_instance *instance,
                                                batten_surface **out)
{
    return reading->any->surface(reading, instance, out);
}
batten_status bat_step_trimmed_surface(const bat_step_reading *reading,
                                       const bat_step_instance *instance,
                                       const bat_step_record *record, batten_surface **out);

#endif
