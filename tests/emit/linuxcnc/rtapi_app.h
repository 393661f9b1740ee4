// A stand-in for LinuxCNC's header: the entry points of a module.
#pragma once
int rtapi_app_main(void);
void rtapi_app_exit(void);
