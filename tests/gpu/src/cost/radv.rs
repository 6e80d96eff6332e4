//! RADV, Mesa's driver for AMD: it compiles for chips that are not there, and tells what a pipeline costs.
//!
//! Every call into Vulkan is here. All handles come from the same live device, and all lists outlive the calls.

use std::ffi::{CStr, CString};

use ash::{khr, vk};

/// The chip: RDNA 2, as in the consoles of 2020.
const CHIP: &str = "NAVI21";
const MISSING: &str =
    "Mesa's RADV, which compiles without a GPU, is not there: `apt-get install mesa-vulkan-drivers libvulkan1`";

/// A device that compiles and cannot run.
pub struct Radv {
    // Declared in the order in which they go.
    statistics: khr::pipeline_executable_properties::Device,
    device: ash::Device,
    instance: ash::Instance,
    _library: ash::Entry,
    /// The driver's name and version.
    pub name: String,
}

/// A binding of a shader: its group, its number, and what is bound.
pub type Binding = (u32, u32, vk::DescriptorType);

impl Radv {
    /// Before the program starts a thread, since it sets environment variables. The error is one line with the cure.
    pub fn new() -> Result<Self, String> {
        // What the driver's cache holds may be of another kind.
        for (name, value) in [("RADV_FORCE_FAMILY", CHIP), ("MESA_SHADER_CACHE_DISABLE", "true")] {
            // SAFETY: no other thread reads the environment yet.
            unsafe { std::env::set_var(name, value) };
        }
        let failed = |error: vk::Result| format!("{MISSING} ({error})");
        // SAFETY: the loader of Vulkan is a library without conditions on loading.
        let library = unsafe { ash::Entry::load() }.map_err(|error| format!("{MISSING} ({error})"))?;
        let application = vk::ApplicationInfo::default().api_version(vk::API_VERSION_1_1);
        let info = vk::InstanceCreateInfo::default().application_info(&application);
        // SAFETY: `info` is complete.
        let instance = unsafe { library.create_instance(&info, None) }.map_err(failed)?;
        // SAFETY: the instance lives.
        let all = unsafe { instance.enumerate_physical_devices() }.map_err(failed)?;
        let named = all.into_iter().map(|physical| (physical, name_of(&instance, physical)));
        let chosen = named.into_iter().find(|(_, name)| name.contains("RADV") && name.contains(CHIP));
        let Some((physical, name)) = chosen else {
            // SAFETY: nothing else was made of it.
            unsafe { instance.destroy_instance(None) };
            return Err(MISSING.to_string());
        };
        let queues = [vk::DeviceQueueCreateInfo::default().queue_priorities(&[1.0])];
        let extensions = [khr::pipeline_executable_properties::NAME.as_ptr()];
        let mut feature =
            vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR::default().pipeline_executable_info(true);
        let info = vk::DeviceCreateInfo::default()
            .queue_create_infos(&queues)
            .enabled_extension_names(&extensions)
            .push_next(&mut feature);
        // SAFETY: `info` is complete; the driver has the extension or says so.
        let device = unsafe { instance.create_device(physical, &info, None) }.map_err(failed)?;
        let statistics = khr::pipeline_executable_properties::Device::new(&instance, &device);
        Ok(Self { statistics, device, instance, _library: library, name })
    }

    /// What the driver tells of compute shader `entry`: names and figures.
    pub fn compile(&self, spirv: &[u32], entry: &str, bindings: &[Binding]) -> Result<Vec<(String, u64)>, String> {
        let entry = CString::new(entry).map_err(|error| error.to_string())?;
        let failed = |error: vk::Result| format!("the driver does not compile it ({error})");
        let module = vk::ShaderModuleCreateInfo::default().code(spirv);
        // SAFETY: naga has made the words.
        let module = unsafe { self.device.create_shader_module(&module, None) }.map_err(failed)?;
        let sets = self.sets(bindings).map_err(failed)?;
        let layout = vk::PipelineLayoutCreateInfo::default().set_layouts(&sets);
        // SAFETY: the sets live.
        let layout = unsafe { self.device.create_pipeline_layout(&layout, None) }.map_err(failed)?;
        let stage = vk::PipelineShaderStageCreateInfo::default()
            .stage(vk::ShaderStageFlags::COMPUTE)
            .module(module)
            .name(&entry);
        let info = vk::ComputePipelineCreateInfo::default()
            .flags(vk::PipelineCreateFlags::CAPTURE_STATISTICS_KHR)
            .stage(stage)
            .layout(layout);
        // SAFETY: module, entry point and layout are those of the shader.
        let made = unsafe { self.device.create_compute_pipelines(vk::PipelineCache::null(), &[info], None) };
        let pipeline = made.map_err(|(_, error)| failed(error))?[0];
        let info = vk::PipelineExecutableInfoKHR::default().pipeline(pipeline);
        // SAFETY: the pipeline was made with the flag that this asks for.
        let told = unsafe { self.statistics.get_pipeline_executable_statistics(&info) }.map_err(failed)?;
        // SAFETY: nothing runs.
        unsafe {
            self.device.destroy_pipeline(pipeline, None);
            self.device.destroy_pipeline_layout(layout, None);
            sets.iter().for_each(|&set| self.device.destroy_descriptor_set_layout(set, None));
            self.device.destroy_shader_module(module, None);
        }
        Ok(told.iter().map(figure).collect())
    }

    /// The groups' layouts, from 0 to the last.
    fn sets(&self, bindings: &[Binding]) -> Result<Vec<vk::DescriptorSetLayout>, vk::Result> {
        let count = bindings.iter().map(|&(group, ..)| group + 1).max().unwrap_or(0);
        let set = |group| {
            let of_group = bindings.iter().filter(|&&(of, ..)| of == group);
            let bindings: Vec<_> = of_group
                .map(|&(_, binding, kind)| {
                    vk::DescriptorSetLayoutBinding::default()
                        .binding(binding)
                        .descriptor_type(kind)
                        .descriptor_count(1)
                        .stage_flags(vk::ShaderStageFlags::COMPUTE)
                })
                .collect();
            let info = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
            // SAFETY: `info` is complete.
            unsafe { self.device.create_descriptor_set_layout(&info, None) }
        };
        (0..count).map(set).collect()
    }
}

impl Drop for Radv {
    fn drop(&mut self) {
        // SAFETY: whatever was made of them is gone.
        unsafe {
            self.device.destroy_device(None);
            self.instance.destroy_instance(None);
        }
    }
}

fn name_of(instance: &ash::Instance, physical: vk::PhysicalDevice) -> String {
    let mut driver = vk::PhysicalDeviceDriverProperties::default();
    let mut properties = vk::PhysicalDeviceProperties2::default().push_next(&mut driver);
    // SAFETY: the instance has made the device.
    unsafe { instance.get_physical_device_properties2(physical, &mut properties) };
    let text = |name: &[std::ffi::c_char]| {
        let bytes: Vec<u8> = name.iter().map(|&c| c as u8).collect();
        CStr::from_bytes_until_nul(&bytes).unwrap_or_default().to_string_lossy().into_owned()
    };
    let name = text(&properties.properties.device_name);
    format!("{name}, {}", text(&driver.driver_info))
}

fn figure(told: &vk::PipelineExecutableStatisticKHR<'_>) -> (String, u64) {
    let name = told.name_as_c_str().unwrap_or_default().to_string_lossy().into_owned();
    // SAFETY: all formats have the size of the union, but `b32`, which the driver does not use for figures.
    (name, unsafe { told.value.u64 })
}
