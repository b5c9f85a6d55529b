#include "viz/noise/noise_data.h"

#include <vtkXMLImageDataWriter.h>

#include <stdexcept>

#include "sightline/io/output_file.h"
#include "viz/noise/space_panels.h"

namespace sightline::viz {

void write_vti(const std::filesystem::path& path, const FieldCube& cube) {
  OutputFile file(path);
  auto writer = vtkSmartPointer<vtkXMLImageDataWriter>::New();
  writer->SetInputData(image_of(cube));
  writer->SetFileName(file.temporary().c_str());
  if (!writer->Write() || writer->GetErrorCode() != 0) throw std::runtime_error(path.string() + ": cannot be written");
  file.commit();
}

}  // namespace sightline::viz
