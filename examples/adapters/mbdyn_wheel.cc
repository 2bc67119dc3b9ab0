/* A wheel of MBDyn by microslip: a user element on the structural node of a wheelset, with its Jacobian.
 *
 * Not compiled here: it needs MBDyn's headers, which are not packaged. Its names are those of base/userelem.h and of
 * modules/ of MBDyn 1.7; mechanics and derivatives are those of wheel.h, which the tests compare with differences.
 * MBDyn is under the GPL: build this as a module of your own.
 *
 *   module load: "libmodule-microslip";
 *   user defined: 11, microslip wheel, NODE, "wheel_1.toml";
 *
 * NODE is in the middle of the axle, y along it to the left. The global axes are those of the track: x along it, y to
 * the left, z up, from midway between the rails at their tops. Left and right wheel have an element each. */
#include "mbconfig.h"

#include "dataman.h"
#include "nonlin.h"
#include "userelem.h"

#include "wheel.h"

class MicroslipWheel : virtual public Elem, public UserDefinedElem {
public:
  MicroslipWheel(unsigned label, const DofOwner* owner, DataManager* manager, MBDynParser& parser)
      : Elem(label, flag(0)), UserDefinedElem(label, owner),
        node_(manager->ReadNode<const StructNode, Node::STRUCTURAL>(parser)) {
    microslip_error error = {0, ""};
    if (wheel_create(&wheel_, parser.GetFileName(), &error) != MICROSLIP_OK) {
      silent_cerr("microslip wheel(" << label << "): " << error.text << std::endl);
      throw ErrGeneric(MBDYN_EXCEPT_ARGS);
    }
    SetOutputFlag(manager->fReadOutput(parser, Elem::LOADABLE));
  }
  ~MicroslipWheel() override { wheel_destroy(&wheel_); }

  void WorkSpaceDim(integer* rows, integer* columns) const override { *rows = *columns = 6; }

  SubVectorHandler& AssRes(SubVectorHandler& residual, doublereal, const VectorHandler&,
                           const VectorHandler&) override {
    residual.ResizeReset(6);
    const wheel_motion motion = motion_of_node();
    wheel_solve(&wheel_, &motion, &load_);
    if (load_.status == MICROSLIP_INVALID_INPUT) 
      throw NonlinearSolver::ErrSimulationDiverged(MBDYN_EXCEPT_ARGS); // the step is repeated with a shorter one
    for (integer k = 1; k <= 6; ++k) residual.PutRowIndex(k, node_->iGetFirstMomentumIndex() + k);
    for (integer k = 1; k <= 3; ++k) {
      residual.PutCoef(k, load_.force[k - 1]);
      residual.PutCoef(3 + k, load_.moment[k - 1]);
    }
    return residual;
  }

  /// -(dF/d(rate) + c dF/d(position)) of what AssRes adds. The angular velocity changes with the rotation parameters g
  /// by dg' - omega x dg.
  VariableSubMatrixHandler& AssJac(VariableSubMatrixHandler& matrix, doublereal c, const VectorHandler&,
                                   const VectorHandler&) override {
    FullSubMatrixHandler& full = matrix.SetFull();
    full.ResizeReset(6, 6);
    const wheel_motion motion = motion_of_node();
    double by[6][12];
    wheel_differentiate(&wheel_, &motion, &load_, by);
    for (integer k = 1; k <= 6; ++k) {
      full.PutRowIndex(k, node_->iGetFirstMomentumIndex() + k);
      full.PutColIndex(k, node_->iGetFirstPositionIndex() + k);
    }
    for (int row = 0; row < 6; ++row)
      for (int k = 0; k < 3; ++k) {
        double unit[3] = {0, 0, 0}, turned[3];
        unit[k] = 1;
        wheel_cross(motion.angular_velocity, unit, turned);
        full.PutCoef(row + 1, k + 1, -(by[row][6 + k] + c * by[row][k]));
        full.PutCoef(row + 1, k + 4, -(by[row][9 + k] + c * (by[row][3 + k] - wheel_dot(by[row] + 9, turned))));
      }
    return matrix;
  }

  void Output(OutputHandler& out) const override {
    if (!bToBeOutput()) return;
    out.Loadable() << GetLabel() << ' ' << load_.status;
    for (int k = 0; k < 3; ++k) out.Loadable() << ' ' << load_.force[k];
    for (int k = 0; k < 3; ++k) out.Loadable() << ' ' << load_.moment[k];
    out.Loadable() << std::endl;
  }

  int iGetNumConnectedNodes() const override { return 1; }
  void GetConnectedNodes(std::vector<const Node*>& nodes) const override { nodes.assign(1, node_); }
  unsigned int iGetNumPrivData() const override { return 0; }
  void SetValue(DataManager*, VectorHandler&, VectorHandler&, SimulationEntity::Hints*) override {}
  std::ostream& Restart(std::ostream& out) const override { return out << "# microslip wheel" << std::endl; }
  unsigned int iGetInitialNumDof() const override { return 0; }
  void InitialWorkSpaceDim(integer* rows, integer* columns) const override { *rows = *columns = 0; }
  VariableSubMatrixHandler& InitialAssJac(VariableSubMatrixHandler& matrix, const VectorHandler&) override {
    matrix.SetNullMatrix();
    return matrix;
  }
  SubVectorHandler& InitialAssRes(SubVectorHandler& residual, const VectorHandler&) override {
    residual.ResizeReset(0);
    return residual;
  }

private:
  wheel_motion motion_of_node() const {
    wheel_motion motion = {};
    const Vec3 &x = node_->GetXCurr(), &v = node_->GetVCurr(), &omega = node_->GetWCurr();
    const Vec3 axle = node_->GetRCurr().GetVec(2);
    for (int k = 0; k < 3; ++k) {
      motion.position[k] = x(k + 1), motion.velocity[k] = v(k + 1);
      motion.axle[k] = axle(k + 1), motion.angular_velocity[k] = omega(k + 1);
    }
    return motion;
  }

  const StructNode* node_;
  rail_wheel wheel_ = {};
  wheel_load load_ = {};
};

extern "C" int module_init(const char*, void*, void*) {
  UserDefinedElemRead* const reader = new UDERead<MicroslipWheel>;
  if (SetUDE("microslip wheel", reader)) return 0;
  delete reader;
  return -1;
}
