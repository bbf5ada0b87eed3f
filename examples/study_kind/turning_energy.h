// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef turning_energy_h
#define turning_energy_h

#include <vfife/study/study_kind.h>

#include <memory>

/** What a containment has to hold: mass, polar inertia and kinetic energy of each body of any case
 * at an overspeed (entries of the section "Turning energy"). Writes bodies.csv and bodies.json. */
std::unique_ptr<vfife::StudyKind> make_turning_energy();

#endif
