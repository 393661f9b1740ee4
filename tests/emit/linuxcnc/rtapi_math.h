// A stand-in for LinuxCNC's header.
#pragma once
#include <math.h>
