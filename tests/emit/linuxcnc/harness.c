// Loads a kinematics module and answers lines: `L length` sets the pin, `F j0 … j8` and `I x y z a b c u v w` ask.
#include <stdio.h>
#include <stdlib.h>
#include "hal.h"
#include "kinematics.h"
#include "rtapi_app.h"

static hal_float_t *only_pin;

int hal_init(const char *name) { return name ? 1 : -1; }
int hal_ready(int component) { return component == 1 ? 0 : -1; }
int hal_exit(int component) { return component == 1 ? 0 : -1; }
void *hal_malloc(long size) { return calloc(1, size); }

int hal_pin_float_newf(hal_pin_dir_t direction, hal_float_t **pin, int component, const char *format, ...)
{
    only_pin = *pin = hal_malloc(sizeof(hal_float_t));
    return direction == HAL_IN && component == 1 && format ? 0 : -1;
}

int main(void)
{
    char kind;
    double in[9], out[9];
    KINEMATICS_FORWARD_FLAGS fflags = 0;
    KINEMATICS_INVERSE_FLAGS iflags = 0;

    if (rtapi_app_main() != 0 || kinematicsType() != KINEMATICS_BOTH || kinematicsSwitchable() != 0)
        return 1;
    printf("%.17g\n", *only_pin);
    while (scanf(" %c", &kind) == 1) {
        int wanted = kind == 'L' ? 1 : 9;
        for (int i = 0; i < wanted; i++)
            if (scanf("%lf", &in[i]) != 1)
                return 1;
        if (kind == 'L') {
            *only_pin = in[0];
        } else if (kind == 'F') {
            EmcPose world;
            int failed = kinematicsForward(in, &world, &fflags, &iflags);
            printf("%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", failed, world.tran.x, world.tran.y,
                   world.tran.z, world.a, world.b, world.c, world.u, world.v, world.w);
        } else {
            EmcPose world = { { in[0], in[1], in[2] }, in[3], in[4], in[5], in[6], in[7], in[8] };
            for (int i = 0; i < 9; i++)
                out[i] = 0;
            int failed = kinematicsInverse(&world, out, &iflags, &fflags);
            printf("%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", failed, out[0], out[1], out[2],
                   out[3], out[4], out[5], out[6], out[7], out[8]);
        }
    }
    rtapi_app_exit();
    return 0;
}
