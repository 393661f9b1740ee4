// A stand-in for LinuxCNC's header: what a kinematics module and the motion controller say to each other.
#pragma once
typedef struct { double x, y, z; } PmCartesian;
typedef struct EmcPose { PmCartesian tran; double a, b, c, u, v, w; } EmcPose;
typedef unsigned long KINEMATICS_FORWARD_FLAGS;
typedef unsigned long KINEMATICS_INVERSE_FLAGS;
typedef enum { KINEMATICS_IDENTITY = 1, KINEMATICS_BOTH = 4 } KINEMATICS_TYPE;
KINEMATICS_TYPE kinematicsType(void);
int kinematicsForward(const double *joints, EmcPose *world, const KINEMATICS_FORWARD_FLAGS *fflags,
                      KINEMATICS_INVERSE_FLAGS *iflags);
int kinematicsInverse(const EmcPose *world, double *joints, const KINEMATICS_INVERSE_FLAGS *iflags,
                      KINEMATICS_FORWARD_FLAGS *fflags);
#define KINS_NOT_SWITCHABLE int kinematicsSwitchable(void) { return 0; }
int kinematicsSwitchable(void);
