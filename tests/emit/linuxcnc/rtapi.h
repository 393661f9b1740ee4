// A stand-in for LinuxCNC's header: what a kinematics module needs of it.
#pragma once
#define EXPORT_SYMBOL(name) extern int exported_##name
#define MODULE_LICENSE(text) extern int license
