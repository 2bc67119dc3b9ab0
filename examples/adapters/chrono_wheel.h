/* A wheel of Chrono by microslip: a load between the body of the track and that of a wheelset.
 *
 * Not compiled here: it needs Chrono, which is not packaged. Its names are those of Chrono 9 (ChLoadBodyBody of
 * chrono/physics/ChLoadsBody.h); the mechanics are those of wheel.h, which the tests run.
 *
 *   auto loads = chrono_types::make_shared<ChLoadContainer>();
 *   loads->Add(chrono_types::make_shared<MicroslipWheel>(track, wheelset, middle_of_track, "wheel_1.toml"));
 *
 * `middle_of_track` is the frame, in absolute axes, midway between the rails at their tops below the wheelset: x along
 * the track, y to the left, z up. The wheelset's own y is along the axle, to the left, and its origin in the axle's
 * middle. Left and right wheel have a load each. Contact by shapes (ChContactForceTorqueSMC) knows one radius and no
 * profiles: switch it off between wheel and rail. */
#pragma once

#include "wheel.h"

#include <chrono/physics/ChLoadsBody.h>

#include <memory>
#include <stdexcept>
#include <string>

class MicroslipWheel : public chrono::ChLoadBodyBody {
public:
  MicroslipWheel(std::shared_ptr<chrono::ChBody> track, std::shared_ptr<chrono::ChBody> wheelset,
                 const chrono::ChFrame<>& middle_of_track, const std::string& case_file)
      : ChLoadBodyBody(wheelset, track, middle_of_track), wheel_(std::make_shared<Handle>(case_file)) {
    loc_application_A = chrono::ChFrame<>(); // the load acts in the middle of the axle
  }

  MicroslipWheel* Clone() const override { return new MicroslipWheel(*this); }
  bool IsStiff() override { return true; } // Chrono then differences the load for implicit steps
  int status() const { return load_.status; }

protected:
  /// Frame A is the wheelset's, frame B the track's; the load is that on the track, the wheelset gets the opposite.
  void ComputeBodyBodyForceTorque(const chrono::ChFrameMoving<>& wheelset, chrono::ChVector3d& force,
                                  chrono::ChVector3d& torque) override {
    wheel_motion motion = {};
    const chrono::ChVector3d axle = wheelset.GetRotMat().GetAxisY(), position = wheelset.GetPos(),
                             velocity = wheelset.GetPosDt(), omega = wheelset.GetAngVelParent();
    for (int k = 0; k < 3; ++k) {
      motion.position[k] = position[k], motion.axle[k] = axle[k];
      motion.velocity[k] = velocity[k], motion.angular_velocity[k] = omega[k];
    }
    wheel_solve(&wheel_->made, &motion, &load_);
    force = -chrono::ChVector3d(load_.force[0], load_.force[1], load_.force[2]);
    torque = -chrono::ChVector3d(load_.moment[0], load_.moment[1], load_.moment[2]);
  }

private:
  struct Handle {
    rail_wheel made = {};
    explicit Handle(const std::string& case_file) {
      microslip_error error = {0, ""};
      if (wheel_create(&made, case_file.c_str(), &error) != MICROSLIP_OK) throw std::runtime_error(error.text);
    }
    ~Handle() { wheel_destroy(&made); }
    Handle(const Handle&) = delete;
  };

  std::shared_ptr<Handle> wheel_;
  wheel_load load_ = {};
};
