// A stand-in for LinuxCNC's header: pins that nobody is connected to.
#pragma once
typedef double hal_float_t;
typedef enum { HAL_IN = 16 } hal_pin_dir_t;
int hal_init(const char *name);
int hal_ready(int component);
int hal_exit(int component);
void *hal_malloc(long size);
int hal_pin_float_newf(hal_pin_dir_t direction, hal_float_t **pin, int component, const char *format, ...);
