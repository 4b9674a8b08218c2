// SPDX-License-Identifier: GPL-3.0-or-later
// What others are compared with: a world that bare calls of ODE step.
#pragma once

#include <ode/ode.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/physics/OdeWorldBuilder.h"

namespace simcore::test {

/// The least that such a world needs: collide, contact joints, set-points, step.
class BareOde {
 public:
  explicit BareOde(const Scene& scene) : ode_(buildOdeWorld(scene.contents().world)) {
    for (const dJointID hinge : ode_->hinges) targets_.push_back(dJointGetHingeAngle(hinge));
  }

  void step() {
    for (std::size_t i = 0; i < ode_->hinges.size(); ++i) {
      const double missing = targets_[i] - dJointGetHingeAngle(ode_->hinges[i]);
      dJointSetHingeParam(ode_->hinges[i], dParamVel, std::clamp(0.4 * missing / 0.004, -2.8, 2.8));
      dJointSetHingeParam(ode_->hinges[i], dParamFMax, 1);
    }
    dSpaceCollide(ode_->top, ode_.get(), &BareOde::collide);
    dWorldQuickStep(ode_->world, 0.004);
    dJointGroupEmpty(ode_->contacts);
  }

  OdeWorld& ode() { return *ode_; }

 private:
  static void collide(void* data, dGeomID a, dGeomID b) {
    auto& ode = *static_cast<OdeWorld*>(data);
    if (dGeomIsSpace(a) != 0 || dGeomIsSpace(b) != 0) return dSpaceCollide2(a, b, data, &BareOde::collide);
    dContact contacts[4];
    const int count = dCollide(a, b, 4, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      contacts[i].surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
      contacts[i].surface.mu = 1;
      contacts[i].surface.soft_erp = 0.3;
      contacts[i].surface.soft_cfm = 1e-5;
      dJointAttach(dJointCreateContact(ode.world, ode.contacts, &contacts[i]), dGeomGetBody(a),
                   dGeomGetBody(b));
    }
  }

  std::unique_ptr<OdeWorld> ode_;
  std::vector<double> targets_;
};

}  // namespace simcore::test
