/* Surfaces of STEP files in the tests of the reader: texts, and points of what they become. */
#ifndef TESTS_EXCHANGE_STEP_READ_SURFACE_TEXT_H
#define TESTS_EXCHANGE_STEP_READ_SURFACE_TEXT_H
#include "exchange/step/parsing.h"
#include "exchange/step/read/shapes.h"

static const bat_step_scale millimetres = {1, 1, 1e-6};

#define COMMON                                                                            \
    "#1=CARTESIAN_POINT('',(1.,2.,3.));#2=DIRECTION('',(0.,0.,1.));"                      \
    "#3=DIRECTION('',(0.,1.,0.));#4=AXIS2_PLACEMENT_3D('',#1,#2,#3);"                     \
    "#5=AXIS1_PLACEMENT('',#1,#2);#6=CARTESIAN_POINT('',(1.,6.,3.));#7=VECTOR('',#2,2.);" \
    "#8=LINE('',#6,#7);#9=VECTOR('',#3,3.);#10=LINE('',#6,#9);"                           \
    "#11=DIRECTION('',(0.,0.,-1.));#12=VECTOR('',#11,1.);#13=LINE('',#6,#12);"            \
    "#14=DIRECTION('',(0.,3.,4.));#15=VECTOR('',#14,5.);#16=LINE('',#6,#15);"             \
    "#17=DIRECTION('',(1.,0.,0.));#18=VECTOR('',#17,1.);#19=LINE('',#6,#18);"             \
    "#20=POLYLINE('',(#6,#1));"

static inline const char *with_common(const char *data)
{
    char *text = test_array(strlen(data) + strlen(COMMON) + 1, 1);
    return step_whole(strcat(strcpy(text, COMMON), data));
}

/* Surface #100 of the text. */
static inline batten_surface *surface_of(const char *data, const bat_step_scale *scale)
{
    batten_surface *surface = NULL;
    step_text_file t = {.notes = NULL};
    CHECK_OK(step_begin(&t, with_common(data)));
    CHECK_OK(bat_step_read_surface(&t.file, step_find(&t, 100), scale, &surface));
    CHECK_INT(t.input.left_out, 0);
    step_end(&t);
    return surface;
}

static inline void check_refusal(const char *data, batten_status status, const char *words)
{
    batten_surface *surface = NULL;
    step_text_file t = {.notes = NULL};
    CHECK_OK(step_begin(&t, with_common(data)));
    CHECK_STATUS(bat_step_read_surface(&t.file, step_find(&t, 100), &millimetres, &surface),
                 status);
    CHECK_MESSAGE(words);
    CHECK(surface == NULL);
    step_end(&t);
}

static inline void evaluate(const batten_surface *surface, double u, double v, double out[3][3])
{
    const batten_interval du = batten_surface_domain(surface, BATTEN_U),
                          dv = batten_surface_domain(surface, BATTEN_V);
    CHECK_OK(batten_surface_evaluate(surface, du.a + u * (du.b - du.a),
                                     dv.a + v * (dv.b - dv.a), 1, &out[0][0]));
}

static inline void check_at(const batten_surface *surface, double u, double v,
                            const double point[3])
{
    double at[3][3];
    evaluate(surface, u, v, at);
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(at[0][k], point[k], 1e-13 * (1 + fabs(point[k])));
}

/* A biquadratic net of 3 x 4 points with knots of two lengths; the parts of a rational one. */
#define NET                                                                  \
    "#30=CARTESIAN_POINT('',(0.,0.,0.));#31=CARTESIAN_POINT('',(0.,1.,0.));" \
    "#32=CARTESIAN_POINT('',(0.,2.,0.));#33=CARTESIAN_POINT('',(0.,3.,1.));" \
    "#34=CARTESIAN_POINT('',(2.,0.,0.));#35=CARTESIAN_POINT('',(2.,1.,4.));" \
    "#36=CARTESIAN_POINT('',(2.,2.,0.));#37=CARTESIAN_POINT('',(2.,3.,0.));" \
    "#38=CARTESIAN_POINT('',(5.,0.,0.));#39=CARTESIAN_POINT('',(5.,1.,0.));" \
    "#40=CARTESIAN_POINT('',(5.,2.,0.));#41=CARTESIAN_POINT('',(5.,3.,-2.));"
#define ROWS "((#30,#31,#32,#33),(#34,#35,#36,#37),(#38,#39,#40,#41))"

#endif
