#include "vehicle.hpp"

#include <Application/Simulation.h>
#include <Models/CooperriderOrthogonalModel.h>
#include <xercesc/parsers/XercesDOMParser.hpp>

#include <stdexcept>

int RunningMode_graphics = 1; // DYTSI reports its progress otherwise
ExecMode Simulation::execMode = NO_THREADS;

DytsiVehicle::DytsiVehicle(const std::string& input_file) {
  using namespace xercesc;
  XMLPlatformUtils::Initialize();
  XercesDOMParser parser; // owns the document, whose elements the model reads while it is set up
  parser.parse(input_file.c_str());
  DOMDocument* document = parser.getDocument();
  XMLCh* name = XMLString::transcode("CooperriderOrthogonalModel");
  DOMNodeList* found = document != nullptr ? document->getElementsByTagName(name) : nullptr;
  XMLString::release(&name);
  if (found == nullptr || found->getLength() == 0)
    throw std::runtime_error(input_file + ": no CooperriderOrthogonalModel in it, or not to be read");
  model_.reset(new DYTSI_Models::CooperriderOrthogonalModel);
  model_->setup(static_cast<DOMElement*>(found->item(0)));
  if (size() == 0) throw std::runtime_error(input_file + ": the model cannot be set up");
  model_->init();
}

DytsiVehicle::~DytsiVehicle() = default;

void DytsiVehicle::set_speed(double speed) {
  model_->getExternalComponents()->set_v(speed);
}

std::size_t DytsiVehicle::size() const {
  return static_cast<std::size_t>(model_->get_N_DOF());
}

std::size_t DytsiVehicle::first_wheelset() const {
  return static_cast<std::size_t>(model_->getComponentList()[3]->get_startingDOF() +
                                  DYTSI_Modelling::WheelSetComponent::Y);
}

State DytsiVehicle::displaced(double lateral) const {
  State state(size(), 0.0);
  for (DYTSI_Modelling::Component* component : model_->getComponentList()) {
    if (component == model_->getComponentList().front()) continue; // the car
    state[static_cast<std::size_t>(component->get_startingDOF())] = lateral;
  }
  return state;
}

void DytsiVehicle::derivative(const State& state, State& rate) const {
  if (model_->computeFun(0, state.data(), rate.data()) != 0)
    throw std::runtime_error("DYTSI finds no forces for this state: beyond the table of contact geometry");
}
